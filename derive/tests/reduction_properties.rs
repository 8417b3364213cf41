//! Reductions of random mechanisms.

use crate::reduced;

use proptest::prelude::*;
use std::fmt::Write;
use tripos_derive::algebra::term::calculus::{Differential, Substitution};
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::diagnostic::Source;
use tripos_derive::model;
use tripos_derive::reduce::reduce;

/// Link of a random mechanism, with its joint to the link before or to the ground.
#[derive(Clone, Debug)]
struct Link {
    /// 0, 1, 2: turns about this axis; 3, 4, 5: slides along it.
    joint: usize,
    /// True if it starts from the link before, false if from the ground.
    on_before: bool,
    /// Position of its mass centre relative to the point before, in units of l/2.
    arm: [i32; 3],
    /// Load on its body: 0 is a spring force, 1 a damper force, other values are none.
    load: usize,
}

fn link() -> impl Strategy<Value = Link> {
    let arm = prop::array::uniform3(-1..3_i32);
    (0..6_usize, prop::bool::weighted(0.7), arm, 0..8_usize).prop_map(|(joint, on_before, arm, load)| Link {
        joint,
        on_before,
        arm,
        load,
    })
}

/// The model of these links; gravity along an axis, if any.
fn text(links: &[Link], gravity: Option<usize>) -> String {
    let mut sections: [String; 6] =
        ["[coordinates]\n", "[speeds]\n", "[frames]\n", "[points]\n", "[bodies]\n", ""].map(str::to_owned);
    let [coordinates, speeds, frames, points, bodies, forces] = &mut sections;
    let (mut frame, mut point) = ("N".to_owned(), "O".to_owned());
    for (i, link) in links.iter().enumerate() {
        if !link.on_before {
            (frame, point) = ("N".to_owned(), "O".to_owned());
        }
        let axis = link.joint % 3;
        let unit = if link.joint < 3 { "rad" } else { "m" };
        let _ = writeln!(coordinates, "q{i} = {{ unit = \"{unit}\" }}\nr{i} = {{ unit = \"rad\" }}");
        let _ = writeln!(speeds, "u{i} = \"q{i}'\"\nw{i} = \"r{i}'\"");
        if link.joint < 3 {
            let _ = writeln!(frames, "A{i} = {{ from = \"{frame}\", axis = {}, angle = \"q{i}\" }}", axis + 1);
            frame = format!("A{i}");
        } else {
            let along: Vec<String> =
                (0..3).map(|k| if k == axis { format!("\"q{i}\"") } else { "0".to_owned() }).collect();
            let _ = writeln!(
                points,
                "S{i} = {{ from = \"{point}\", frame = \"{frame}\", position = [{}] }}",
                along.join(", ")
            );
            point = format!("S{i}");
        }
        // Each link has a rotor of its own, so that no mass matrix is singular.
        let _ = writeln!(frames, "B{i} = {{ from = \"{frame}\", axis = {}, angle = \"r{i}\" }}", (axis + 1) % 3 + 1);
        let arm: Vec<String> = link.arm.iter().map(|k| format!("\"{k}*l/2\"")).collect();
        let _ =
            writeln!(points, "P{i} = {{ from = \"{point}\", frame = \"{frame}\", position = [{}] }}", arm.join(", "));
        point = format!("P{i}");
        let _ = writeln!(
            bodies,
            "b{i} = {{ frame = \"B{i}\", centre = \"P{i}\", mass = \"m\", inertia = {{ diagonal = [\"I\", \"2*I\", \"3*I\"] }} }}"
        );
        let load = match link.load {
            0 => format!("-k*q{i}{}", if link.joint < 3 { "*l" } else { "" }),
            1 => format!("-c*u{i}{}", if link.joint < 3 { "*l" } else { "" }),
            _ => continue,
        };
        let _ = writeln!(forces, "[forces.f{i}]\non = \"b{i}\"\nframe = \"N\"\nvector = [0, \"{load}\", 0]");
    }
    let mut out = "name = \"Random\"\n[parameters]\n".to_owned();
    for (name, unit) in [("m", "kg"), ("l", "m"), ("I", "kg*m^2"), ("k", "N/m"), ("c", "N*s/m"), ("g", "m/s^2")] {
        let _ = writeln!(out, "{name} = {{ unit = \"{unit}\", value = 0.5, positive = true }}");
    }
    let [coordinates, speeds, frames, points, bodies, forces] = sections;
    out = out
        + &coordinates
        + &speeds
        + "[inertial]\nframe = \"N\"\norigin = \"O\"\n"
        + &frames
        + &points
        + &bodies
        + &forces;
    if let Some(axis) = gravity {
        let along: Vec<&str> = (0..3).map(|k| if k == axis { "\"-g\"" } else { "0" }).collect();
        let _ = writeln!(out, "[gravity]\nframe = \"N\"\nacceleration = [{}]", along.join(", "));
    }
    out
}

/// Output number `kind` of link i.
fn output(kind: usize, i: usize) -> String {
    [
        format!("q{i}"),
        format!("u{i}"),
        format!("r{i}"),
        format!("w{i}*u{i}"),
        format!("sin(r{i})"),
        format!("u{i}'"),
        "kinetic_energy".to_owned(),
    ][kind]
        .replace("/l", "")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// Goal: whatever is asked of whatever mechanism, the reduced system is proved, has no more states than the model,
    /// and its states need nothing but states. Method: what is returned is proved; here is tested that there is
    /// something to return, and that the energy, where it is kept, is constant along the rates as they are returned.
    #[test]
    fn every_reduction_is_proved_and_closed(
        links in prop::collection::vec(link(), 1..4),
        gravity in prop::option::of(0..3_usize),
        wanted in prop::collection::vec((0..7_usize, 0..3_usize), 1..3),
        folded in any::<bool>(),
    ) {
        let text = text(&links, gravity);
        let mut model = model::load(&Source::from_text("model.toml", &text)).map_err(|e| TestCaseError::fail(format!("{e}\n{text}")))?;
        let mut outputs: Vec<String> = wanted.iter().map(|(kind, i)| output(*kind, i % links.len())).collect();
        outputs.sort();
        outputs.dedup();
        let free = if folded { "" } else { "\nfree = [\"m\", \"l\", \"I\", \"k\", \"c\", \"g\"]" };
        let scene = reduced::with_start(&model, &format!("outputs = {outputs:?}{free}"));
        let scene = reduced::scene_of(&mut model, &scene);
        let r = reduce(&model, &scene).map_err(|e| TestCaseError::fail(format!("{e}\n{text}\n{outputs:?}")))?;
        let full = model.coordinates.len() + model.speeds.len();
        prop_assert!(r.states.len() + r.quadratures.len() <= full);
        prop_assert!(r.proof.exponent() > 32.0);
        let e = &r.derivation.equations;
        let mut arena = r.arena().clone();
        let mut inline = Substitution::default();
        for d in r.products.iter().chain(&e.definitions) {
            let value = inline.apply(&mut arena, d.value);
            inline.set(d.symbol, value);
        }
        let quadratures: Vec<_> = r.quadratures.iter().map(|q| q.symbol).collect();
        for (q, rate) in e.coordinates.iter().zip(&e.coordinate_rates) {
            let rate = inline.apply(&mut arena, *rate);
            let is_state = r.states.iter().any(|s| s.symbol == *q);
            prop_assert!(!is_state || quadratures.iter().all(|s| !arena.mentions(rate, *s)));
        }
        // dE/dt, the accelerations by M u̇ = f: with free u̇ it is ∂E/∂u u̇ + ∂E/∂q q̇, and a multiple of the rows.
        if r.has_energy && e.variables.len() == 1 {
            let energy = arena.add(e.kinetic_energy, e.potential_energy);
            let energy = inline.apply(&mut arena, energy);
            let (m, f) = (inline.apply(&mut arena, e.matrix[0][0]), inline.apply(&mut arena, e.forcing[0]));
            let rate = arena.div(f, m).expect("a mass");
            let rates: Vec<_> = e.coordinates.iter().zip(&e.coordinate_rates).map(|(q, k)| (*q, inline.apply(&mut arena, *k))).chain([(e.variables[0], rate)]).collect();
            let change = Differential::along(&rates).apply(&mut arena, energy);
            prop_assert_eq!(zero_test(&arena, change), ZeroTest::Zero);
        }
    }
}
