//! Springs and dampers between points, and positions that constraints name.
//!
//! Truth: forces and energies by hand.

use crate::common;

use common::{edited, errors, read};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::mechanics::{Derivation, SolvedAccelerations, derive, load_divisors};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model};

/// The pendulum on a cart, with a spring from the end of the rod to a point beside the rail.
fn sprung(spring: &str) -> String {
    let points = "C = { from = \"P\", frame = \"A\", position = [0, \"-length\", 0] }\n\
                  E = { from = \"P\", frame = \"A\", position = [0, \"-2*length\", 0] }\n\
                  W = { from = \"O\", frame = \"N\", position = [\"length\", \"3*length\", 0] }";
    let parameters = "g = { unit = \"m/s^2\", value = 9.81 }\nk = { unit = \"N/m\", value = 70, positive = true }\n\
                      c = { unit = \"N*s/m\", value = 3 }";
    edited(
        &[
            ("C = { from = \"P\", frame = \"A\", position = [0, \"-length\", 0] }", points),
            ("g = { unit = \"m/s^2\", value = 9.81 }", parameters),
        ],
        spring,
    )
}

const TO_THE_WALL: &str =
    "[springs.s]\non = \"rod\"\nat = \"E\"\nagainst_at = \"W\"\nstiffness = \"k\"\nfree_length = \"length\"\n";

/// Parameters m, length, I, g, k, c; then x, q and their rates.
const NUMBERS: [f64; 10] = [2.0, 0.5, 0.1, 9.81, 70.0, 3.0, 0.3, 0.7, -0.4, 1.1];

fn values(model: &Model, formulation: Formulation) -> Vec<f64> {
    let Derivation { mut arena, equations } = derive(model, formulation).unwrap();
    let solved = SolvedAccelerations::new(&mut arena, &equations).unwrap().accelerations;
    let inputs = [model.p(), model.q(), equations.variables.clone()].concat();
    let values = [&equations.unknowns[..2], &[equations.potential_energy, equations.power]].concat();
    Tape::stepwise(&arena, &inputs, &solved.steps, &values).unwrap().evaluate(&NUMBERS)
}

/// Accelerations, V and the power by hand: the cart and the rod about its mass centre, of which gravity is known.
fn by_hand(damping: f64) -> [f64; 4] {
    let [m, l, i, g, k, _, x, q, u, w] = NUMBERS;
    let (s, c) = q.sin_cos();
    // From the end E to the wall W, and its rate.
    let (dx, dy) = (l - (x + 2.0 * l * s), 3.0 * l + 2.0 * l * c);
    let (vx, vy) = (-(u + 2.0 * l * c * w), -2.0 * l * s * w);
    let d = dx.hypot(dy);
    let rate = (dx * vx + dy * vy) / d;
    let pull = k * (d - l) + damping * rate;
    let (fx, fy) = (pull * dx / d, pull * dy / d);
    // Along x and along q: E moves by (1, 0) and by 2 l (cos q, sin q).
    let (along_x, along_q) = (fx, 2.0 * l * (c * fx + s * fy));
    let (a, b, e) = (2.0 * m, m * l * c, i + m * l * l);
    let (f, h) = (along_x + m * l * s * w * w, along_q - m * g * l * s);
    let determinant = a * e - b * b;
    let energy = k * (d - l) * (d - l) / 2.0 - m * g * l * c;
    [(e * f - b * h) / determinant, (a * h - b * f) / determinant, energy, -damping * rate * rate]
}

fn close(found: &[f64], expected: &[f64]) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-12 * expected.abs().max(1.0), "{found}, expected {expected}");
    }
}

#[test]
fn a_spring_pulls_along_the_way_between_its_ends() {
    for (addition, damping) in [("", 0.0), ("damping = \"c\"\n", 3.0)] {
        let model = read(&sprung(&format!("{TO_THE_WALL}{addition}"))).unwrap_or_else(|e| panic!("{e}"));
        for formulation in [Formulation::Kane, Formulation::Lagrange] {
            close(&values(&model, formulation), &by_hand(damping));
        }
    }
}

/// Goal: the energy of a spring is in the energy that proofs speak of. Method: roots of sums of cosines, which no rule
/// integrates.
#[test]
fn a_sprung_mechanism_keeps_its_energy() {
    let model = read(&sprung(TO_THE_WALL)).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = tripos_derive::mechanics::derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    assert!(proof.integrals.iter().any(|i| i.is_energy() && i.verdict.is_equal()), "{}", proof.search.covered);
}

/// Goal: a spring between two bodies pulls both. Method: it does not change the total momentum along the rail.
#[test]
fn a_spring_between_bodies_pulls_both() {
    let text = "[springs.s]\non = \"rod\"\nat = \"E\"\nagainst = \"cart\"\nstiffness = \"k\"\n";
    // A particle can be held where it is alone.
    let model = read(&sprung(text)).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = tripos_derive::mechanics::derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let names: Vec<String> = proof.integrals.iter().map(|i| i.name(&model, &derivations.kinematics.arena)).collect();
    assert!(names.iter().any(|name| name.contains("momentum p_x")), "{names:?}");
    assert!(proof.integrals.iter().any(tripos_derive::prove::Integral::is_energy), "{names:?}");
}

#[test]
fn what_cannot_be_a_spring_is_refused() {
    for (text, message) in [
        ("[springs.s]\non = \"rod\"\nat = \"E\"\nagainst_at = \"W\"\n", "has neither `stiffness` nor `damping`"),
        ("[springs.s]\non = \"rod\"\nat = \"E\"\nstiffness = \"k\"\n", "against_at"),
        ("[springs.s]\non = \"rod\"\nat = \"E\"\nagainst_at = \"Z\"\nstiffness = \"k\"\n", "no point `Z`"),
        ("[springs.s]\non = \"rod\"\nat = \"E\"\nagainst_at = \"E\"\nstiffness = \"k\"\n", "in one place at all times"),
        (
            "[springs.s]\non = \"rod\"\nat = \"W\"\nagainst_at = \"O\"\nstiffness = \"k\"\n",
            "the end `W` of spring `s` moves in `rod`",
        ),
        ("[springs.s]\non = \"rod\"\nat = \"E\"\nagainst_at = \"W\"\nstiffness = \"c\"\n", "must be in"),
        ("[springs.s]\non = \"rod\"\nat = \"E\"\nagainst_at = \"W\"\nstiffness = \"k*x\"\n", "cannot stand"),
    ] {
        let found = errors(&sprung(text)).to_string();
        assert!(found.contains(message), "`{message}` is not in\n{found}");
    }
}

/// Goal: constraints may name positions. Method: a loop closed by the positions of its pins is the loop closed by its
/// angles, and a height that is held is solved for.
#[test]
fn constraints_name_positions() {
    let text = include_str!("../../models/four_bar/model.toml");
    let named = text
        .replace("a*cos(q1) + b*cos(q2) = d + c*cos(q3)", "p(Q) @ N [1] = p(R) @ N [1]")
        .replace("a*sin(q1) + b*sin(q2) = c*sin(q3)", "p(Q) @ N [2] = p(R) @ N [2]");
    assert_ne!(text, named);
    let kane = |text: &str| {
        let model = read(text).unwrap_or_else(|e| panic!("{e}"));
        let derivation = derive(&model, Formulation::Kane).unwrap();
        let inputs = [model.p(), model.q(), model.u()].concat();
        let entries = [derivation.equations.matrix.concat(), derivation.equations.forcing].concat();
        let state = [0.3, 0.8, 0.6, 0.7, 1.0, 2.0, 1.5, 9.81, 0.4, 0.5, 1.1, 2.0];
        Tape::new(&derivation.arena, &inputs, &entries).unwrap().evaluate(&state)
    };
    close(&kane(&named), &kane(text));
}

/// Goal: places where loads divide by zero are listed, each with its load. Method: a spring whose ends meet, a
/// potential whose slope divides by a coordinate, and one that divides by a positive sum, which is never zero.
#[test]
fn loads_that_divide_by_what_may_vanish_are_listed() {
    let potentials = "[potentials]\nwell = \"k*length^3/x\"\nsmooth = \"k*length^4/(x^2 + length^2)\"\n";
    let model = read(&(sprung(TO_THE_WALL) + potentials)).unwrap_or_else(|e| panic!("{e}"));
    let mut arena = model.arena.clone();
    let list = load_divisors(&mut arena, &model);
    let found: Vec<(&str, bool)> = list.iter().map(|divisor| (divisor.load.as_str(), divisor.is_distance)).collect();
    assert_eq!(found, [("s", true), ("well", false)]);
    let x = model.coordinates[0].symbol;
    assert!(
        arena.mentions(list[1].value, x) && list[1].zero_divisor_meaning().contains("the load `well` divides by it")
    );
    assert_eq!(list[0].zero_divisor_meaning(), "the ends of the spring `s` meet");
}
