//! Contacts that touch at the start of a run, and bodies that come to rest on one another.

use crate::impacts::{BALL, FALL, end, near, run, scene};
use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::diagnostic::Source;
/// Goal: a start with an impact, one with an overlap, and one at rest are distinguished.
#[test]
fn what_touches_at_the_start_hits_rests_or_is_refused() {
    let at = |z: f64, w: f64| FALL.replace("z = 1\nw = 0", &format!("z = {z:?}\nw = {w:?}"));
    let hits = run(BALL, &at(0.0, -3.0));
    assert!(near(hits.column_of_quantity("w").unwrap()[0], 1.5, 1e-15) && near(hits.impacts()[0].loss, 6.75, 1e-14));
    assert!(hits.impacts()[0].t.abs() < 1e-15, "{:?}", hits.impacts());
    let rests = run(BALL, &at(0.0, 0.0));
    assert!(rests.impacts().is_empty() && end(&rests, "z").abs() < 1e-15);
    let overlaps = scene(BALL, &at(-0.1, 0.0)).simulate(&Overrides::default()).unwrap();
    let why = overlaps.failure().unwrap();
    assert!(why.contains("gap of the contact `floor` is -0.1 "), "{why}");
}

const TWO: &str = r#"
name = "Two on a line"
[parameters]
m = { unit = "kg", value = 1, positive = true }
g = { unit = "m/s^2", value = 10 }
[coordinates]
z1 = { unit = "m" }
z2 = { unit = "m" }
[speeds]
w1 = "z1'"
w2 = "z2'"
[inertial]
frame = "N"
origin = "O"
[points]
A = { from = "O", frame = "N", position = [0, 0, "z1"] }
B = { from = "O", frame = "N", position = [0, 0, "z2"] }
[particles]
a = { point = "A", mass = "m" }
b = { point = "B", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#;

/// Goal: bodies that bounce on one another come to rest on one another, whatever the restitution. Method: two dropped
/// bodies end at rest on the floor and on each other, and have lost all their energy.
#[test]
fn what_falls_on_one_another_comes_to_rest_so() {
    for e in [0.3, 0.5, 0.7] {
        let text = format!(
            "model = \"model.toml\"\nspan = [0, 20]\n[start]\nz1 = 1\nz2 = 1.5\nw1 = 0\nw2 = 0\n[impacts.floor]\ngap = \"z1\"\nrestitution = {e}\n\
             [impacts.balls]\ngap = \"z2 - z1\"\nrestitution = {e}\n"
        );
        let model = tripos_derive::model::load(&Source::from_text("model.toml", TWO)).unwrap_or_else(|e| panic!("{e}"));
        let scene = Scene::parse(Mechanism::new(model), &text).unwrap_or_else(|e| panic!("{e}"));
        let run = scene.simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
        assert!(run.failure().is_none(), "{e}: {:?}", run.objections());
        let end = |name: &str| *run.column_of_quantity(name).unwrap().last().unwrap();
        assert!(end("z1").abs() < 1e-9 && end("z2").abs() < 1e-9, "{e}: {} {}", end("z1"), end("z2"));
        let lost: f64 = run.solution.impacts.iter().map(|impact| impact.loss).sum();
        assert!((lost - 25.0).abs() < 1e-6, "{e}: {lost}");
        assert!(run.notes.iter().filter(|note| note.contains("shorter without end")).count() <= 3, "{:?}", run.notes);
    }
}

/// Goal: an unknown force is never shown as a number. Method: an acceleration is requested in a scene in which a
/// contact may be held.
#[test]
fn what_contacts_would_falsify_is_refused() {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", TWO)).unwrap_or_else(|e| panic!("{e}"));
    let text = "model = \"model.toml\"\nspan = [0, 1]\noutputs = [\"w1'\"]\n[start]\nz1 = 1\nz2 = 1.5\nw1 = 0\nw2 = 0\n[impacts.floor]\ngap = \
                \"z1\"\nrestitution = 0.5\n";
    let scene = Scene::parse(Mechanism::new(model), text).unwrap_or_else(|e| panic!("{e}"));
    let error = scene.simulate(&Overrides::default()).err().map(|error| error.to_string()).unwrap_or_default();
    assert!(error.contains("they would lack the forces of closed contacts"), "{error}");
}
