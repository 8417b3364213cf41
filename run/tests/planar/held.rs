//! Contacts held although nothing presses them, and contacts with gap and slip in one motion.

use super::world::{Body, Contact, Pin, World};
use crate::impacts::scene;
use tripos::{Overrides, Run};

fn run(model: &str, text: &str) -> Run {
    let run = scene(model, text).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
    assert!(run.objections().is_empty(), "{:?} {:?}", run.objections(), run.events());
    run
}

fn end(run: &Run, name: &str) -> f64 {
    run.end[run.names.iter().position(|known| known == name).unwrap()]
}

/// A body in a plane that moves in the frame of one that turns about its own centre.
const CARRIED: &str = r#"
name = "Body on a turntable"
[parameters]
g = { unit = "m/s^2", value = 9.81, positive = true }
m = { unit = "kg", value = 1.364, positive = true }
I = { unit = "kg*m^2", value = 0.203, positive = true }
L = { unit = "m", value = 1 }
wall = { unit = "m", value = 0.85 }
[inertial]
frame = "N"
origin = "O"
[bodies]
table = { mass = "m", inertia = "I" }
body = { mass = "m", inertia = "I" }
[joints]
T = { kind = "pin", body = "table", axis = 3 }
B = { kind = "planar", body = "body", to = "table", axis = 3, centre = ["0.288*L", "0.524*L", 0] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// Goal: a body that slides along a wall without being pressed goes on, up and down again. Truth: the centre of a free
/// body flies along a parabola to the wall. There, with e = 0, its velocity across is lost. Friction takes μ times as
/// much of the velocity along the wall, or all of it. From there it falls, at the wall or beside it.
#[test]
fn what_slides_along_a_wall_without_a_force_goes_on_both_ways() {
    for (mu, rise) in [(0.0, 0.5), (0.2, 1.5), (0.2, -1.0), (0.9, 0.3), (0.9, 2.5)] {
        // The turntable turns. In it, places are those of a body that flies straight on outside.
        let (angle, omega, own, spin) = (-0.47_f64, -0.52, -0.73_f64, -0.81);
        let (place, velocity) = ([0.3, -0.1], [0.9, rise]);
        let turned = |v: [f64; 2], a: f64| [a.cos() * v[0] - a.sin() * v[1], a.sin() * v[0] + a.cos() * v[1]];
        let arm = turned([0.288, 0.524], angle + own);
        let joint = [place[0] - arm[0], place[1] - arm[1]];
        let rate = omega + spin;
        let moves = [velocity[0] + rate * arm[1], velocity[1] - rate * arm[0]];
        let seen = turned(joint, -angle);
        let carried = [moves[0] + omega * joint[1], moves[1] - omega * joint[0]];
        let seen_moves = turned(carried, -angle);
        let along =
            if mu > 0.0 { format!("friction = {mu:?}\nalong = \"v(body_centre) @ N [2]\"") } else { String::new() };
        let text = format!(
            "span = [0, 1.2]\noutputs = [{{ name = \"x\", value = \"p(body_centre) @ N [1]\" }}, {{ name = \"y\", value = \"p(body_centre) @ N [2]\" }}]\n[start]\nq_T = {angle:?}\n\"q_T'\" = {omega:?}\nq_B_1 = {:?}\nq_B_2 = {:?}\nq_B_3 = {own:?}\n\
             \"q_B_1'\" = {:?}\n\"q_B_2'\" = {:?}\n\"q_B_3'\" = {spin:?}\n[integration]\natol = 1e-11\n[impacts.wall]\ngap = \"wall - p(body_centre) @ N [1]\"\nrestitution = 0\n{along}\n",
            seen[0], seen[1], seen_moves[0], seen_moves[1]
        );
        let run = run(CARRIED, &text);
        let hit = (0.85 - place[0]) / velocity[0];
        let (y, v) = (place[1] + rise * hit - 4.905 * hit * hit, rise - 9.81 * hit);
        let left = 1.2 - hit;
        let v = v - v.signum() * v.abs().min(mu * velocity[0]);
        let truth = y + v * left - 4.905 * left * left;
        assert!((end(&run, "x") - 0.85).abs() < 1e-8, "{mu} {rise}: {}", end(&run, "x"));
        assert!((end(&run, "y") - truth).abs() < 1e-6, "{mu} {rise}: {} for {truth}", end(&run, "y"));
    }
}

/// A lever on a pin, with a pendulum on it.
const LEVER: &str = r#"
name = "Lever"
[parameters]
g = { unit = "m/s^2", value = 9.81, positive = true }
m = { unit = "kg", value = 1.702, positive = true }
I1 = { unit = "kg*m^2", value = 0.211, positive = true }
I2 = { unit = "kg*m^2", value = 0.152, positive = true }
L = { unit = "m", value = 1 }
wall = { unit = "m", value = 0.19 }
[inertial]
frame = "N"
origin = "O"
[bodies]
lever = { mass = "m", inertia = "I1" }
hangs = { mass = "m", inertia = "I2" }
[joints]
J1 = { kind = "pin", body = "lever", axis = 3, centre = ["0.25*L", 0, 0] }
J2 = { kind = "pin", body = "hangs", to = "lever", at = [0, "0.24*L", 0], axis = 3, centre = ["0.2*L", 0, 0] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// Goal: a lever that comes down on a wall is held there while it is pressed, whatever the friction. Its point can slip
/// or open only by turning back. Truth: the simulation of this folder, up to the opening of the lever if it opens: a
/// gap that is held by the friction of one way.
#[test]
fn a_lever_rests_on_a_wall_as_long_as_it_is_pressed() {
    for (mu, q2) in [(0.9, 0.35_f64), (0.3, 0.35)] {
        let text = format!(
            "span = [0, 1.1]\n[start]\nq_J1 = 0.41\nq_J2 = {q2:?}\n\"q_J1'\" = 0.46\n\"q_J2'\" = 0.39\n[integration]\nrtol = 1e-11\natol = 1e-12\n[impacts.wall]\ngap = \"p(lever_centre) @ N [1] - wall\"\n\
             restitution = 0\nfriction = {mu:?}\nalong = \"v(lever_centre) @ N [2]\"\n"
        );
        let run = run(LEVER, &text);
        let own = |moment: f64| Body { mass: 1.702, moment };
        let contact = Contact { body: 0, at: [0.0; 2], other: None, normal: [1.0, 0.0], offset: 0.19, mu, e: 0.0 };
        let world = World {
            bodies: vec![own(0.211), own(0.152)],
            pins: vec![
                Pin { body: 0, at: [-0.25, 0.0], to: None, there: [0.0; 2] },
                Pin { body: 1, at: [-0.2, 0.0], to: Some(0), there: [-0.25, 0.24] },
            ],
            contacts: vec![contact],
            gravity: 9.81,
            poisson: false,
        };
        let (a, b) = (0.41_f64, 0.41 + q2);
        let (u, w) = (0.46, 0.46 + 0.39);
        let pin = [-0.24 * a.sin(), 0.24 * a.cos()];
        let start = vec![
            0.25 * a.cos(),
            0.25 * a.sin(),
            a,
            pin[0] + 0.2 * b.cos(),
            pin[1] + 0.2 * b.sin(),
            b,
            -0.25 * a.sin() * u,
            0.25 * a.cos() * u,
            u,
            -pin[1] * u - 0.2 * b.sin() * w,
            pin[0] * u + 0.2 * b.cos() * w,
            w,
        ];
        let (y, told) = world.run(&start, 1.1).unwrap_or_else(|why| panic!("{mu} {q2}: {why}; {:?}", run.events()));
        let (first, second) = (end(&run, "q_J1") - y[2], end(&run, "q_J1") + end(&run, "q_J2") - y[5]);
        assert!(
            first.abs() < 1e-7 && second.abs() < 1e-7,
            "{mu} {q2}: {first:e} {second:e} {told:?} {:?}",
            run.events()
        );
        assert!(!told.is_empty(), "it comes down");
    }
}
