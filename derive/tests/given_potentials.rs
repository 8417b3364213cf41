//! Potentials that the file gives, `[potentials]`.
//!
//! Truth: the same mechanisms with forces, torques and springs instead, which use none of the code for potentials;
//! exact energies.

use crate::common;

use common::{edited, errors, read};
use nalgebra::{DMatrix, DVector};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::mechanics::{Derivation, derive, derive_all};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model};

fn model(text: &str) -> Model {
    read(text).unwrap_or_else(|e| panic!("{e}"))
}

/// Accelerations, then reactions or multipliers, by one formulation, and V and the power; all at arbitrary numbers.
fn values(model: &Model, formulation: Formulation) -> (Vec<f64>, [f64; 2]) {
    let Derivation { arena, equations } =
        derive(model, formulation).unwrap_or_else(|e| panic!("{}: {e}", formulation.name()));
    let inputs = [model.p(), model.q(), equations.variables.clone()].concat();
    let energies = [equations.potential_energy, equations.power];
    let values = [equations.matrix.concat(), equations.forcing.clone(), energies.to_vec()].concat();
    let number = |(at, input): (usize, &Expr)| match arena.symbol_name(*input) {
        Some("e0") => 0.1,
        Some("e1" | "e3") => 0.5,
        Some("e2") => 0.7,
        _ => 0.7 + 0.031 * ((at * 7 % 11) as f64),
    };
    let numbers: Vec<f64> = inputs.iter().enumerate().map(number).collect();
    let values = Tape::new(&arena, &inputs, &values).unwrap().evaluate(&numbers);
    let n = equations.forcing.len();
    let (matrix, rest) = values.split_at(n * n);
    let solution = DMatrix::from_row_slice(n, n, matrix).lu().solve(&DVector::from_row_slice(&rest[..n])).unwrap();
    (solution.iter().copied().collect(), [rest[n], rest[n + 1]])
}

fn close(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-10 * expected.abs().max(1.0), "{what}: {found}, expected {expected}");
    }
}

/// Checks that two descriptions are one mechanism by every formulation, and that the first is proved equivalent.
fn are_one(given: &str, other: &str) {
    let (given, other) = (model(given), model(other));
    for formulation in Formulation::ALL {
        let [found, expected] = [&given, &other].map(|model| values(model, formulation));
        close(&found.0, &expected.0, formulation.name());
        close(&found.1, &expected.1, formulation.name());
    }
    is_proved(&given);
}

fn is_proved(model: &Model) {
    let mut derivations = derive_all(model).unwrap();
    derivations.add(model, Formulation::GibbsAppell).unwrap();
    for (formulation, equations) in &derivations.list {
        assert!(equations.is_ok(), "{}, {}: {:?}", model.title, formulation.name(), equations.as_ref().err());
    }
    let proof = prove(model, &mut derivations);
    assert!(proof.is_equivalent(), "{}", model.title);
    assert_eq!(proof.pairs.len(), 6);
}

/// A chain of two rods and a bob, described by angles from the vertical.
const CHAIN: &str = r#"
name = "Chain"
[parameters]
m = { unit = "kg", positive = true }
l = { unit = "m", positive = true }
g = { unit = "m/s^2", positive = true }
k = { unit = "N*m", positive = true }
s = { unit = "N/m", positive = true }
[inertial]
frame = "N"
origin = "O"
[coordinates]
a = { unit = "rad" }
b = { unit = "rad" }
[speeds]
u = "a'"
v = "b' + a'"
[frames]
A = { from = "N", axis = 3, angle = "a" }
B = { from = "N", axis = 3, angle = "b" }
[points]
Ao = { from = "O", frame = "A", position = ["l/2", 0, 0] }
P = { from = "O", frame = "A", position = ["l", 0, 0] }
Bo = { from = "P", frame = "B", position = ["l/2", 0, 0] }
Q = { from = "P", frame = "B", position = ["l", 0, 0] }
W = { from = "O", frame = "N", position = ["2*l", "3*l", "l"] }
[bodies]
one = { frame = "A", centre = "Ao", mass = "m", inertia = "m*l^2/12" }
two = { frame = "B", centre = "Bo", mass = "2*m", inertia = "m*l^2/6" }
[gravity]
frame = "N"
acceleration = ["g", 0, 0]
"#;

/// Goal: a potential of a joint acts like a spring in the joint. Method: a torque between the rods; the reactions
/// agree as well.
#[test]
fn a_potential_of_relative_angles_is_a_spring_in_the_joint() {
    let given = format!("{CHAIN}[potentials]\ntwist = \"k*(b - a)^2/2 + k*(1 - cos(a))\"\n");
    let torques = format!(
        "{CHAIN}[torques]\ntwist = {{ on = \"two\", against = \"one\", frame = \"N\", vector = [0, 0, \"-k*(b - a)\"] }}\n\
         hinge = {{ on = \"one\", frame = \"N\", vector = [0, 0, \"-k*sin(a)\"] }}\n"
    );
    let (given_model, other) = (model(&given), model(&torques));
    for formulation in Formulation::ALL {
        let [found, expected] = [&given_model, &other].map(|model| values(model, formulation));
        close(&found.0, &expected.0, formulation.name());
        // The integral of a torque has a constant of its own.
        close(&found.1[1..], &expected.1[1..], formulation.name());
    }
    is_proved(&given_model);
}

/// Goal: potentials may contain distances, also in space, with roots and powers. Method: a spring with the same ends.
/// The two differ only in the points at which they pull, which only reactions show.
#[test]
fn a_potential_of_a_distance_moves_what_a_spring_moves() {
    let given =
        format!("{CHAIN}[potentials]\nrope = {{ value = \"s*(distance(Q, W) - l)^2/2\", about = \"a rope\" }}\n");
    let spring = format!(
        "{CHAIN}[springs]\nrope = {{ on = \"two\", at = \"Q\", against_at = \"W\", stiffness = \"s\", free_length = \"l\" }}\n"
    );
    let (given, other) = (model(&given), model(&spring));
    for formulation in Formulation::ALL {
        let [found, expected] = [&given, &other].map(|model| values(model, formulation));
        close(&found.0[..2], &expected.0[..2], formulation.name());
        close(&found.1, &expected.1, formulation.name());
    }
    is_proved(&given);
    let mut derivations = derive_all(&given).unwrap();
    let proof = prove(&given, &mut derivations);
    assert!(proof.integrals.iter().any(|i| i.is_energy() && i.verdict.is_equal()), "{}", proof.search.covered);
}

/// Goal: a potential in spherical coordinates, without a joint to act in, is a force on its particle. Method:
/// Newton's law of gravitation as a force.
#[test]
fn a_field_of_a_planet_is_a_force_on_the_particle() {
    let text = r#"
name = "Planet"
[parameters]
m = { unit = "kg", positive = true }
G = { unit = "N*m^2/kg", positive = true }
[inertial]
frame = "N"
origin = "O"
[coordinates]
r = { unit = "m" }
a = { unit = "rad" }
b = { unit = "rad" }
[speeds]
u = "r'"
v = "a'"
w = "b'"
[frames]
A = { from = "N", axis = 3, angle = "a" }
B = { from = "A", axis = 2, angle = "b" }
[points]
P = { from = "O", frame = "B", position = ["r", 0, 0] }
[particles]
moon = { point = "P", mass = "m" }
"#;
    let force = "[forces]\nfield = { on = \"moon\", frame = \"B\", vector = [\"-G*m/r^2\", 0, 0] }\n";
    are_one(&format!("{text}[potentials]\nfield = \"-G*m/r\"\n"), &format!("{text}{force}"));
    let model = model(&format!("{text}[potentials]\nfield = \"-G*m/distance(O, P)\"\n"));
    is_proved(&model);
}

/// Goal: a potential that depends on time has a power, which is the rest of the energy. Method: dV/dt by hand.
#[test]
fn the_power_of_a_potential_in_time_is_its_slope_along_time() {
    let text = edited(&[("g = {", "k = { unit = \"N/m\", value = 70 }\nw = { unit = \"1/s\", value = 3 }\ng = {")], "");
    let model = model(&format!("{text}[potentials]\ndrive = \"k*(x - length*sin(w*t))^2/2\"\n"));
    is_proved(&model);
    let mut derivations = derive_all(&model).unwrap();
    let powers: Vec<_> = derivations.list.iter().map(|(_, e)| e.as_ref().unwrap().power).collect();
    let arena = &mut derivations.kinematics.arena;
    let by_hand = "-k*(x - length*sin(w*t))*length*w*cos(w*t)";
    let by_hand = tripos_derive::algebra::text::parse::parse_free(arena, by_hand).unwrap();
    let clock = arena.symbol("t'");
    let mut at_one = Substitution::new(&[(clock, Expr::ONE)]);
    for power in powers {
        let power = at_one.apply(arena, power);
        let difference = arena.sub(power, by_hand);
        assert_eq!(zero_test(arena, difference), ZeroTest::Zero);
    }
}

/// Goal: potentials of dependent coordinates act on a closed loop. Method: a torque on the rocker; multipliers and
/// reactions agree.
#[test]
fn a_potential_of_a_dependent_angle_acts_on_the_rocker() {
    let text = include_str!("../../models/four_bar/model.toml")
        .replace("[coordinates]", "k = { unit = \"N*m\", value = 3 }\n[coordinates]");
    let torque = "[torques]\nspring = { on = \"rocker\", frame = \"N\", vector = [0, 0, \"-k*q3\"] }\n";
    are_one(&format!("{text}[potentials]\nspring = \"k*q3^2/2\"\n"), &format!("{text}{torque}"));
}

/// Goal: bodies do not determine Euler parameters, whose norm is held. Method: a constant force on a point of the bus.
#[test]
fn a_potential_of_an_attitude_by_euler_parameters() {
    let text = include_str!("../../models/satellite/model.toml")
        .replace(
            "[bodies]",
            "[points]\ntip = { from = \"O\", frame = \"S\", position = [\"arm\", \"2*arm\", 0] }\n[bodies]",
        )
        .replace("[parameters]", "[parameters]\narm = { unit = \"m\", value = 1 }\nF = { unit = \"N\", value = 2 }");
    let force = "[forces]\npull = { on = \"bus\", at = \"tip\", frame = \"N\", vector = [0, \"F\", 0] }\n";
    let (given, other) =
        (model(&format!("{text}[potentials]\npull = \"-F*p(tip) @ N [2]\"\n")), model(&format!("{text}{force}")));
    for formulation in Formulation::ALL {
        let [found, expected] = [&given, &other].map(|model| values(model, formulation));
        // No rule finds the potential of the force. What both leave to the norm, and to what holds the bus, differs.
        let moving = if formulation.is_in_rates() { given.coordinates.len() } else { given.speeds.len() };
        close(&found.0[..moving], &expected.0[..moving], formulation.name());
    }
    is_proved(&given);
}

#[test]
fn what_cannot_be_a_potential_is_refused() {
    let text = edited(&[("g = {", "k = { unit = \"N/m\", value = 70 }\ng = {")], "[inputs]\nF = { unit = \"N\" }\n");
    for (formula, message) in [
        ("k*u1*x", "the speed `u1` cannot stand in potential `s`"),
        ("k*x'*x", "the time derivative `x'` cannot stand in potential `s`"),
        ("-F*x", "the input `F` cannot stand in potential `s`"),
        ("k*z^2", "unknown name `z`"),
        ("k*x^2*v(C) @ N [1]", "the velocity `v(C) @ N [1]` cannot stand in potential `s`"),
        ("k*x^2 + m*omega(rod) @ N [3]", "cannot stand in potential `s`"),
        ("k*distance(C, Z)^2", "there is no point `Z`"),
        ("k*x", "potential `s` must be in N*m, but `k*x` is in N"),
        ("k*length^2", "depends on no coordinate: it exerts nothing"),
        ("k*(p(O) @ N [1])^2", "depends on no coordinate: it exerts nothing"),
        ("k*x^4/(p(O) @ N [1])^2", "divides by a term that is always zero"),
    ] {
        let found = errors(&format!("{text}[potentials]\ns = \"{formula}\"\n")).to_string();
        assert!(
            found.contains(message) && found.contains("help") && found.contains("model.toml:"),
            "`{message}` is not in\n{found}"
        );
    }
}
