//! Impacts without loss of energy.

use super::{Mechanism, Random, mechanism};
use crate::impacts::scene;
use crate::random_trees::times;
use tripos::Overrides;

/// Bodies that touch at 1 to 4 places, without friction.
fn touching(random: &mut Random) -> Mechanism {
    let count = 1 + random.below(5);
    let mut made = mechanism(random, count);
    for _ in 0..=random.below(4) {
        made.meets(random, 0.0, 0.0, 1.0);
    }
    made
}

/// Goal: elastic impacts lose no energy, in any configuration. Method: impacts of up to five bodies, which touch at up
/// to four places, against impulses of a dense linear system in the rates of all bodies. The energies before and after
/// are compared.
#[test]
fn elastic_impacts_of_random_bodies_keep_energy_to_rounding() {
    let (mut hits, mut bad) = (0, Vec::new());
    // Two seeds have gaps closed only to rounding of lengths, and one has another impact soon after.
    for seed in (0..60 * times() as u64).chain([488, 521, 779]) {
        let made = touching(&mut Random::new(seed));
        let (model, text) = made.text(1e-3);
        let closed = vec![true; made.world.contacts.len()];
        let velocities: Vec<f64> = (0..closed.len()).map(|at| made.world.velocity(&made.start, at)[0]).collect();
        if velocities.iter().all(|v| *v >= 0.0) {
            continue;
        }
        // A body between two walls that it touches both has no motion.
        let Ok(truth) = made.world.hit(&made.start, &closed) else { continue };
        hits += 1;
        let (before, after) = (made.world.energy(&made.start), made.world.energy(&truth));
        let run =
            scene(&model, &text).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}\n{model}\n{text}"));
        if let Some(why) = run.failure() {
            println!("{seed}: {why}; {velocities:?}; {:e}", after - before);
            bad.push(seed);
            continue;
        }
        let off = |(name, at): &(String, usize)| {
            let place = run.names.iter().position(|known| *known == format!("u_{name}")).unwrap();
            let first = run.column_of_quantity(&run.names[place]).unwrap()[0];
            (first - truth[3 * made.world.bodies.len() + at]).abs()
        };
        let apart = made.coordinates.iter().map(off).fold(0.0, f64::max);
        let loss = run.impacts()[0].loss;
        if apart > 1e-8 || loss.abs() > 1e-12 * before.abs().max(1.0) || (after - before).abs() > 1e-9 {
            println!("{seed}: apart {apart:e} loss {loss:e} energy {:e} {velocities:?}", after - before);
            bad.push(seed);
        }
    }
    assert!(bad.is_empty() && hits > 30, "{bad:?} of {hits}");
}

/// Two balls of radius 0.1 m on a line, and a wall at 1.1 m.
const BALLS: &str = r#"
name = "Two balls and a wall"
[parameters]
m = "1 kg"
R = "0.1 m"
wall = "1.1 m"
[coordinates]
x1 = { unit = "m" }
x2 = { unit = "m" }
[speeds]
v1 = "x1'"
v2 = "x2'"
[inertial]
frame = "N"
origin = "O"
[points]
A = { from = "O", frame = "N", position = ["x1", 0, 0] }
B = { from = "O", frame = "N", position = ["x2", 0, 0] }
[particles]
first = { point = "A", mass = "m" }
second = { point = "B", mass = "m" }
"#;

/// Goal: rounding does not lead to the refusal of an elastic impact, in the run or in the second one that gives its
/// errors. Truth: equal balls exchange their velocities. At a wall that the second touches, both hit at once, the first
/// comes back and the second stays, by either law.
#[test]
fn equal_balls_change_their_velocities_and_come_back_from_a_wall() {
    let ends = |text: &str, truth: [f64; 2]| {
        let run = scene(BALLS, text).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
        assert!(run.objections().is_empty(), "{text}: {:?}", run.objections());
        assert!(run.energy_drift.unwrap() < 1e-14, "{text}: {:?}", run.energy_drift);
        for (name, truth) in ["v1", "v2"].into_iter().zip(truth) {
            let end = run.end[run.names.iter().position(|known| known == name).unwrap()];
            assert!((end - truth).abs() < 1e-14, "{text}: {name} = {end}, not {truth}");
        }
    };
    let balls = "[impacts.balls]\ngap = \"x2 - x1 - 2*R\"\nrestitution = 1\n";
    for tenth in 1..=40 {
        let v = f64::from(tenth) / 10.0;
        ends(&format!("span = [0, 3]\nstart = {{ x1 = 0.2, x2 = 0.6, v1 = {v:?}, v2 = 0 }}\n{balls}"), [0.0, v]);
        for law in ["newton", "poisson"] {
            let law = format!("law = \"{law}\"\n");
            let wall = format!("{balls}{law}[impacts.wall]\ngap = \"wall - x2 - R\"\nrestitution = 1\n{law}");
            let text = format!("span = [0, 0.1]\nstart = {{ x1 = 0.8, x2 = 1.0, v1 = {v:?}, v2 = 0 }}\n{wall}");
            ends(&text, [-v, 0.0]);
        }
    }
}

/// Goal: impacts at one instant that follow one another keep energy as well. Truth: of three equal balls that touch,
/// the first comes at 1 m/s while the third leaves at 0.4. The first two exchange their velocities, then the second, at
/// 1, and the third do; the first stays.
#[test]
fn what_leaves_is_hit_after_what_it_leaves() {
    let text = "span = [0, 0.1]\nstart = { x1 = 0, x2 = 0, x3 = 0, u1 = 1, u2 = 0, u3 = 0.4 }\nparameters = { m1 = 1, m2 = 1, m3 = 1, e = 1 }\n\
                [impacts.ab]\ngap = \"x2 - x1\"\nrestitution = \"e\"\n[impacts.bc]\ngap = \"x3 - x2\"\nrestitution = \"e\"\n";
    let run =
        scene(crate::saltation::balls::ROW, text).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
    assert!(run.objections().is_empty(), "{:?}", run.objections());
    for (name, truth) in [("u1", 0.0), ("u2", 0.4), ("u3", 1.0)] {
        let end = run.end[run.names.iter().position(|known| known == name).unwrap()];
        assert!((end - truth).abs() < 1e-14, "{name} = {end}, not {truth}");
    }
    assert!(run.impacts().len() == 1 && run.impacts()[0].loss.abs() < 1e-15, "{:?}", run.impacts());
}
