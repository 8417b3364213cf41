//! Reactions that the file does not name, found from the motions that connections prevent.
//!
//! Truth: the models of the library, which name their reactions; textbook values; and, for random mechanisms, the
//! proof that the Newton–Euler equations with the found reactions are equal to Kane's and Lagrange's.

use crate::common::read;
use std::fmt::Write;
use std::path::Path;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::mechanics::{Derivations, Formulation, derive_all};
use tripos_derive::model::{Model, ReactionKind};
use tripos_derive::prove::{Proof, prove};

fn loaded(text: &str) -> Model {
    read(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// Proves a model, and checks that there are three pairs, all equal.
fn proved(model: &Model, what: &str) -> (Proof, Derivations) {
    let mut derivations = derive_all(model).unwrap_or_else(|e| panic!("{what}: {e}"));
    let proof = prove(model, &mut derivations);
    assert!(proof.is_equivalent() && proof.pairs.len() == 3, "{what}: {:?} {:?}", proof.missing, proof.pairs);
    (proof, derivations)
}

/// A model file without the reactions that `left_out` selects, without the domain, which may mention them, and
/// without the names of reactions that enforce constraints.
fn without(text: &str, left_out: impl Fn(&str) -> bool) -> String {
    let mut file: toml::Table = text.parse().unwrap();
    file.remove("domain");
    if let Some(reactions) = file.get_mut("reactions").and_then(toml::Value::as_table_mut) {
        reactions.retain(|name, _| !left_out(name));
    }
    let constraints = file.get_mut("constraints").and_then(toml::Value::as_table_mut);
    for constraint in constraints.into_iter().flat_map(|list| list.iter_mut()).filter_map(|(_, c)| c.as_table_mut()) {
        constraint.remove("enforced_by");
    }
    file.to_string()
}

/// Goal: no reaction need be typed. Method: the library without its own; there are no more than it names.
#[test]
fn the_librarys_reactions_are_found() {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let mut count = 0;
    for folder in std::fs::read_dir(models).unwrap() {
        let path = folder.unwrap().path().join("model.toml");
        let text = std::fs::read_to_string(&path).unwrap();
        let stated = loaded(&text);
        if stated.stated_reactions().is_empty() {
            // Nothing was typed.
            proved(&stated, &path.display().to_string());
            continue;
        }
        let found = loaded(&without(&text, |_| true));
        assert!(stated.reactions.iter().all(|r| r.is_stated) && found.reactions.iter().all(|r| !r.is_stated));
        proved(&found, &path.display().to_string());
        let kinds = |model: &Model| {
            let is_force = |r: &&tripos_derive::model::Reaction| matches!(r.kind, ReactionKind::Force { .. });
            let forces = model.reactions.iter().filter(is_force).count();
            (forces, model.reactions.len() - forces)
        };
        // Some files name what is 0 as well.
        let ((forces, torques), named) = (kinds(&found), kinds(&stated));
        assert!(forces <= named.0 && torques <= named.1, "{}: {:?}", path.display(), found.reactions);
        count += 1;
    }
    assert!(count >= 12, "{count}");
}

/// Goal: missing reactions are completed, and a complete set is left alone. Method: one reaction of a model taken out
/// at a time.
#[test]
fn stated_reactions_are_completed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/chaotic_pendulum/model.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let all = loaded(&text);
    for left_out in &all.reactions {
        let rest = without(&text, |name| name == left_out.name);
        let model = loaded(&rest);
        assert!(model.reactions.len() <= all.reactions.len(), "without {}", left_out.name);
        assert!(model.reactions.iter().filter(|r| r.is_stated).count() + 1 == all.reactions.len());
        proved(&model, &left_out.name);
    }
}

/// Goal: found reactions have the right values. Method: a disc that rolls straight down an incline α: friction m g sin
/// α/3, upward, and m g cos α from the ground; J. L. Meriam & L. G. Kraige, *Dynamics*, 7th edition (2012), sample
/// problem 6/5.
#[test]
fn the_ground_holds_a_disc_on_an_incline() {
    let model = loaded(
        "name = \"disc on an incline\"\n[parameters]\nm = { unit = \"kg\", value = 2 }\nr = { unit = \"m\", value = 0.3 }\ng = { unit \
         = \"m/s^2\", value = 9.81 }\nalpha = { unit = \"rad\", value = 0.4 }\n[coordinates]\nx = { unit = \"m\" }\nq = { unit = \"rad\" \
         }\n[speeds]\nu = \"x'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[frames]\nB = { from = \"N\", axis = 3, angle = \"-q\" \
         }\n[points]\nC = { from = \"O\", frame = \"N\", position = [\"x\", \"r\", 0] }\nP = { from = \"C\", frame = \"N\", position = \
         [0, \"-r\", 0] }\n[bodies.disc]\nframe = \"B\"\ncentre = \"C\"\nmass = \"m\"\ninertia = { diagonal = [\"m*r^2/4\", \
         \"m*r^2/4\", \"m*r^2/2\"] }\n[gravity]\nframe = \"N\"\nacceleration = [\"g*sin(alpha)\", \"-g*cos(alpha)\", 0]\n\
         [rolling.contact]\nbody = \"disc\"\nat = \"P\"\n",
    );
    let (proof, mut derivations) = proved(&model, "disc");
    let equations = derivations.get(Formulation::Kane).unwrap().clone();
    let arena = &mut derivations.kinematics.arena;
    let rate = arena.div(equations.forcing[0], equations.matrix[0][0]).unwrap();
    assert_eq!(print_text(arena, rate), "2*g*sin(alpha)/3");
    let names: Vec<&str> = proof.reactions.iter().map(|r| r.name.as_str()).collect();
    assert_eq!(names, ["disc_force_n1", "disc_force_n2"]);
    let acceleration = 2.0 / 3.0 * 9.81 * f64::sin(0.4);
    for (reaction, expected) in
        proof.reactions.iter().zip([-2.0 * 9.81 * f64::sin(0.4) / 3.0, 2.0 * 9.81 * f64::cos(0.4)])
    {
        let rates = model.speeds.iter().map(|s| s.rate);
        let inputs: Vec<_> = model.p().into_iter().chain(model.q()).chain(model.u()).chain(rates).collect();
        let tape = Tape::new(arena, &inputs, &[reaction.value]).unwrap();
        let value = tape.evaluate(&[2.0, 0.3, 9.81, 0.4, 0.7, 0.2, 1.1, acceleration])[0];
        assert!((value - expected).abs() < 1e-12, "{} is {value}, not {expected}", reaction.name);
    }
}

/// A small generator of numbers (Knuth's linear congruential one).
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }
}

/// A tree of rigid bodies and particles on joints of all kinds, with offsets in all directions.
fn tree(chance: &mut Chance) -> String {
    let bodies = 1 + chance.below(3);
    let [mut coordinates, mut frames, mut points, mut masses] = [const { String::new() }; 4];
    let (mut n, mut held) = (0, vec![("N".to_owned(), "O".to_owned())]);
    let mut coordinate = |unit: &str, coordinates: &mut String| {
        n += 1;
        writeln!(coordinates, "q{n} = {{ unit = \"{unit}\" }}").unwrap();
        format!("q{n}")
    };
    for body in 1..=bodies {
        let (frame, point) = held[usize::try_from(chance.below(held.len() as u64)).unwrap()].clone();
        let turns = [1, 2, 3, 1, 0, 1][usize::try_from(chance.below(6)).unwrap()];
        let slides = usize::from(turns == 0 || chance.below(4) == 0);
        let mut last = frame.clone();
        let mut axis = chance.below(3);
        for turn in 0..turns {
            let name = format!("F{body}{turn}");
            let angle = coordinate("rad", &mut coordinates);
            writeln!(frames, "{name} = {{ from = \"{last}\", axis = {}, angle = \"{angle}\" }}", axis + 1).unwrap();
            axis = (axis + 1 + chance.below(2)) % 3;
            last = name;
        }
        if turns == 0 {
            writeln!(frames, "F{body} = {{ from = \"{last}\", axis = 1, angle = \"0\" }}").unwrap();
            last = format!("F{body}");
        }
        let mut position = ["0".to_owned(), "0".to_owned(), "0".to_owned()];
        for _ in 0..slides {
            position[usize::try_from(chance.below(3)).unwrap()] = coordinate("m", &mut coordinates);
        }
        let quoted = position.map(|e| format!("\"{e}\"")).join(", ");
        writeln!(points, "P{body} = {{ from = \"{point}\", frame = \"{frame}\", position = [{quoted}] }}").unwrap();
        let mut arm = || ["\"l\"", "\"-2*l\"", "0"][usize::try_from(chance.below(3)).unwrap()];
        let arms = [arm(), arm(), arm()].join(", ");
        writeln!(points, "C{body} = {{ from = \"P{body}\", frame = \"{last}\", position = [{arms}] }}").unwrap();
        writeln!(points, "E{body} = {{ from = \"P{body}\", frame = \"{last}\", position = [\"l\", 0, \"3*l\"] }}")
            .unwrap();
        writeln!(
            masses,
            "[bodies.b{body}]\nframe = \"{last}\"\ncentre = \"C{body}\"\nmass = \"m\"\ninertia = {{ diagonal = [\"2*I\", \"3*I\", \
             \"4*I\"] }}"
        )
        .unwrap();
        held.push((last, format!("E{body}")));
    }
    let mut speeds = String::new();
    for i in 1..=n {
        writeln!(speeds, "u{i} = \"q{i}'\"").unwrap();
    }
    format!(
        "name = \"a tree\"\n[parameters]\nm = {{ unit = \"kg\", value = 1, positive = true }}\nl = {{ unit = \"m\", value = 1, positive \
         = true }}\nI = {{ unit = \"kg*m^2\", value = 1, positive = true }}\ng = {{ unit = \"m/s^2\", value = 9.81 }}\n[coordinates]\n\
         {coordinates}[speeds]\n{speeds}[inertial]\nframe = \"N\"\norigin = \"O\"\n[frames]\n{frames}[points]\n{points}{masses}[gravity]\n\
         frame = \"N\"\nacceleration = [\"g/3\", \"-g\", \"g/2\"]\n"
    )
}

/// Goal: every tree has Newton–Euler equations. Method: random ones, with pins, sliders, cylinders, universal joints
/// and balls.
#[test]
fn random_trees_are_derived_three_ways() {
    let mut chance = Chance(5);
    for case in 0..40 {
        let text = tree(&mut chance);
        let model = loaded(&text);
        proved(&model, &format!("case {case}\n{text}"));
    }
}
