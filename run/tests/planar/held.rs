//! Contacts that are held where a gap and a slip are one motion.

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

/// Goal: a lever that comes down on a wall, where its point can neither slip nor open but by turning back, is held there as long as it is pressed, whatever friction. Truth: the simulation of this folder, to where the lever opens if it does: a gap
/// that is held by the friction of one way.
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
