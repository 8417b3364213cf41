//! Linkages through the dead points of their speeds, and starts in such poses.
//!
//! Truth: the same linkage as a chain of rods in angles from the horizontal. A dense solve gives the multipliers of its
//! closure, and the state is moved back onto the closure after each step of RK4. The chain chooses no speeds, so it has
//! no dead points.

use crate::driven::{near, run, scene};
use crate::random_trees::times;
use nalgebra::{DMatrix, DVector};
use std::fmt::Write;
use tripos::{Overrides, Run, Scene};

const G: f64 = 9.81;

/// Closure of the chain at its end.
#[derive(Clone, Copy, PartialEq)]
enum End {
    /// A pin at (distance, 0).
    Pin(f64),
    /// A piston of this mass, which slides along the horizontal.
    Piston(f64),
}

/// Chain of rods, the first from the origin; each rod has its mass and length.
#[derive(Clone)]
struct Chain {
    rods: Vec<(f64, f64)>,
    end: End,
}

impl Chain {
    /// Mass that the end of a rod carries, apart from half of its own mass: all rods behind it and the piston.
    fn carried(&self, at: usize) -> f64 {
        let piston = if let End::Piston(mass) = self.end { mass } else { 0.0 };
        self.rods[at + 1..].iter().map(|(mass, _)| mass).sum::<f64>() + piston
    }

    /// The factor of the cosine of the difference of two angles in the mass matrix.
    fn coupling(&self, i: usize, j: usize) -> f64 {
        let (i, j) = (i.min(j), i.max(j));
        let ((_, a), (mass, b)) = (self.rods[i], self.rods[j]);
        if i == j { (mass / 3.0 + self.carried(i)) * a * a } else { a * b * (mass / 2.0 + self.carried(j)) }
    }

    /// Rows of the closure along the angles, its right-hand sides for the accelerations, and its gaps.
    fn closure(&self, angles: &[f64], rates: &[f64]) -> (DMatrix<f64>, DVector<f64>, DVector<f64>) {
        let lengths = || self.rods.iter().map(|(_, length)| length).zip(angles).zip(rates);
        let up = lengths().map(|((l, a), _)| l * a.cos());
        let along = lengths().map(|((l, a), _)| -l * a.sin());
        let open_up: f64 = lengths().map(|((l, a), _)| l * a.sin()).sum();
        let open_along: f64 = lengths().map(|((l, a), _)| l * a.cos()).sum();
        let side_up: f64 = lengths().map(|((l, a), w)| l * a.sin() * w * w).sum();
        let side_along: f64 = lengths().map(|((l, a), w)| l * a.cos() * w * w).sum();
        let n = angles.len();
        match self.end {
            End::Piston(_) => (
                DMatrix::from_iterator(n, 1, up).transpose(),
                DVector::from_element(1, side_up),
                DVector::from_element(1, open_up),
            ),
            End::Pin(distance) => (
                DMatrix::from_iterator(n, 2, up.chain(along)).transpose(),
                DVector::from_vec(vec![side_up, side_along]),
                DVector::from_vec(vec![open_up, open_along - distance]),
            ),
        }
    }

    fn accelerations(&self, angles: &[f64], rates: &[f64]) -> DVector<f64> {
        let (rows, sides, _) = self.closure(angles, rates);
        let (n, m) = (angles.len(), rows.nrows());
        let mut matrix = DMatrix::zeros(n + m, n + m);
        let mut right = DVector::zeros(n + m);
        for i in 0..n {
            for j in 0..n {
                matrix[(i, j)] = self.coupling(i, j) * (angles[i] - angles[j]).cos();
                right[i] -= self.coupling(i, j) * (angles[i] - angles[j]).sin() * rates[j] * rates[j];
            }
            let (mass, length) = self.rods[i];
            right[i] -= G * length * (mass / 2.0 + self.carried(i)) * angles[i].cos();
        }
        matrix.view_mut((n, 0), (m, n)).copy_from(&rows);
        matrix.view_mut((0, n), (n, m)).copy_from(&rows.transpose());
        right.rows_mut(n, m).copy_from(&sides);
        matrix.lu().solve(&right).expect("a regular pose").rows(0, n).into_owned()
    }

    /// Moves angles and rates onto the closure.
    fn settle(&self, state: &mut [f64]) {
        let n = state.len() / 2;
        for _ in 0..20 {
            let (rows, _, open) = self.closure(&state[..n], &state[n..]);
            let step = rows.clone().pseudo_inverse(1e-12).unwrap() * open;
            for (x, step) in state.iter_mut().zip(step.iter()) {
                *x -= step;
            }
        }
        let (rows, ..) = self.closure(&state[..n], &state[n..]);
        let open = &rows * DVector::from_column_slice(&state[n..]);
        let step = rows.pseudo_inverse(1e-12).unwrap() * open;
        for (x, step) in state[n..].iter_mut().zip(step.iter()) {
            *x -= step;
        }
    }

    /// State after a time, from a start.
    fn moved(&self, start: &[f64], time: f64) -> Vec<f64> {
        const STEPS: u32 = 12_000;
        let (n, h) = (start.len() / 2, time / f64::from(STEPS));
        let slope = |y: &[f64]| [&y[n..], self.accelerations(&y[..n], &y[n..]).as_slice()].concat();
        let plus = |y: &[f64], k: &[f64], h: f64| y.iter().zip(k).map(|(y, k)| y + h * k).collect::<Vec<_>>();
        let mut y = start.to_vec();
        for _ in 0..STEPS {
            let k1 = slope(&y);
            let k2 = slope(&plus(&y, &k1, h / 2.0));
            let k3 = slope(&plus(&y, &k2, h / 2.0));
            let k4 = slope(&plus(&y, &k3, h));
            for i in 0..2 * n {
                y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            }
            self.settle(&mut y);
        }
        y
    }

    /// Text of the model in which the joints in `chosen` have speeds. The piston has one if it is among them, as the
    /// last.
    fn model(&self, chosen: &[usize]) -> String {
        let mut text = "name = \"Chain\"\n[parameters]\ng = \"9.81 m/s^2\"\n".to_owned();
        for (at, (mass, length)) in self.rods.iter().enumerate() {
            let _ = writeln!(text, "m{at} = \"{mass} kg\"\nl{at} = \"{length} m\"");
        }
        let own = match self.end {
            End::Pin(distance) => format!("D = \"{distance} m\"\n"),
            End::Piston(mass) => format!("mp = \"{mass} kg\"\n"),
        };
        text += &own;
        text += "[inertial]\nframe = \"N\"\norigin = \"O\"\n[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n[bodies]\n";
        for at in 0..self.rods.len() {
            let _ = writeln!(text, "k{at} = {{ mass = \"m{at}\", inertia = \"m{at}*l{at}^2/12\" }}");
        }
        if let End::Piston(_) = self.end {
            text += "piston = { mass = \"mp\", inertia = { diagonal = [0, 0, 0] } }\n";
        }
        text += "[joints]\n";
        let last = self.rods.len() - 1;
        for at in 0..=last {
            let to =
                if at == 0 { String::new() } else { format!("to = \"k{}\", at = [\"l{}\", 0, 0], ", at - 1, at - 1) };
            let speed = if chosen.contains(&at) { format!("\"u{at}\"") } else { String::new() };
            let _ = writeln!(
                text,
                "P{at} = {{ kind = \"pin\", body = \"k{at}\", {to}centre = [\"l{at}/2\", 0, 0], coordinates = [\"q{at}\"], speeds = [{speed}] }}"
            );
        }
        let speed = if chosen.contains(&(last + 1)) { "\"v\"" } else { "" };
        text + &match self.end {
            End::Pin(_) => format!(
                "E = {{ kind = \"pin\", body = \"k{last}\", at = [\"D\", 0, 0], body_at = [\"l{last}\", 0, 0] }}\n"
            ),
            End::Piston(_) => format!(
                "guide = {{ kind = \"slider\", axis = 1, body = \"piston\", coordinates = [\"x\"], speeds = [{speed}] }}\n\
                 wrist = {{ kind = \"pin\", body = \"piston\", to = \"k{last}\", at = [\"l{last}\", 0, 0] }}\n"
            ),
        }
    }

    /// Coordinates of the model, which are angles from rod to rod, or their rates.
    fn relative(list: &[f64]) -> Vec<f64> {
        (0..list.len()).map(|at| if at == 0 { list[0] } else { list[at] - list[at - 1] }).collect()
    }

    /// A scene from angles and rates on the closure, given by all rates.
    fn scene(&self, chosen: &[usize], state: &[f64], time: f64, how: &str) -> Scene {
        let n = self.rods.len();
        let mut text = format!("model = \"model.toml\"\nspan = [0, {time}]\n[start]\n");
        for (at, (q, rate)) in Self::relative(&state[..n]).iter().zip(Self::relative(&state[n..])).enumerate() {
            let _ = writeln!(text, "q{at} = {q:?}\n\"q{at}'\" = {rate:?}");
        }
        scene(&self.model(chosen), &format!("{text}[integration]\n{how}\n"))
    }
}

/// Pseudorandom numbers from 0 to 1, always the same.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f64 / 16_777_216.0
    }

    fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
}

/// Kind of the joint at the end of a chain.
#[derive(Clone, Copy)]
enum LastJoint {
    Pin,
    Piston,
}

/// A random chain that turns, in a state on its closure.
fn turning(random: &mut Random, rods: usize, last: LastJoint) -> (Chain, Vec<f64>) {
    loop {
        let lengths: Vec<f64> = (0..rods).map(|at| if at == 0 { 0.2 } else { random.within(0.45, 0.7) }).collect();
        let end = match last {
            LastJoint::Pin => End::Pin(random.within(0.5, 0.7)),
            LastJoint::Piston => End::Piston(random.within(0.3, 1.0)),
        };
        let chain = Chain { rods: lengths.iter().map(|l| (random.within(0.4, 1.5), *l)).collect(), end };
        let mut state: Vec<f64> = match rods {
            2 => vec![random.within(0.4, 1.2), -0.3],
            3 => vec![random.within(0.4, 1.2), 0.7, -1.2],
            _ => vec![random.within(0.4, 1.2), 1.0, -0.4, -1.3],
        };
        state.extend((0..rods).map(|at| if at == 0 { random.within(12.0, 18.0) } else { random.within(-1.0, 1.0) }));
        chain.settle(&mut state);
        let (_, _, open) = chain.closure(&state[..rods], &state[rods..]);
        if open.norm() < 1e-14 && state.iter().all(|x| x.abs() < 30.0) {
            return (chain, state);
        }
    }
}

fn by(scene: &Scene, by: &str) -> Run {
    let how = Overrides { by: Some(by.into()), ..Overrides::default() };
    scene.simulate(&how).unwrap_or_else(|e| panic!("{by}: {e}"))
}

/// Goal: a linkage moves the same whichever speeds are chosen, by every formulation and method, in as few steps, also
/// where the speeds fail. Method: random four-bars, slider-cranks and five-bars whose crank turns, with speeds of other
/// joints, which fail in each turn; against the chain without speeds.
#[test]
fn random_linkages_go_through_the_dead_points_of_their_speeds() {
    let mut random = Random(44);
    let mut changed = 0;
    for case in 0..6 * times() {
        let (rods, last, choices): (usize, LastJoint, [&[usize]; 2]) = match case % 3 {
            0 => (3, LastJoint::Pin, [&[2], &[1]]),
            1 => (2, LastJoint::Piston, [&[2], &[1]]),
            _ => (4, LastJoint::Pin, [&[1, 3], &[2, 3]]),
        };
        let (chain, state) = turning(&mut random, rods, last);
        let time = 0.6;
        let truth = chain.moved(&state, time);
        let angles = Chain::relative(&truth[..rods]);
        for (choice, (formulation, method, tolerance)) in choices.iter().cycle().zip([
            ("kane", "dop853", 1e-11),
            ("kane", "radau5", 1e-9),
            ("lagrange", "dop853", 1e-11),
            ("newton-euler", "taylor", 1e-11),
            ("kane", "taylor", 1e-11),
            ("lagrange", "ode45", 1e-8),
        ]) {
            let how = format!(
                "method = \"{method}\"\nrtol = {tolerance:e}\natol = {tolerance:e}\nstep_limit = 20000\nsamples = 11"
            );
            let run = by(&chain.scene(choice, &state, time, &how), formulation);
            let what = format!("case {case}, {choice:?} by {formulation} and {method}");
            assert!(run.failure().is_none(), "{what}: {:?}", run.objections());
            changed += usize::from(run.notes.iter().any(|note| note.contains("speeds changed")));
            for (at, angle) in angles.iter().enumerate() {
                let found = *run.column_of_quantity(&format!("q{at}")).unwrap().last().unwrap();
                assert!((found - angle).abs() < 3e3 * tolerance, "{what}: q{at} is off by {:e}", found - angle);
            }
        }
    }
    assert!(changed > 15, "{changed} runs changed their speeds");
}

/// Goal: a start in a dead point works by the rates of the crank. With the speed alone it is refused with advice.
/// Method: slider-cranks that begin with crank and rod in line, by the speed of the piston, which is 0 there, against
/// the chain.
#[test]
fn a_start_in_a_dead_point_needs_a_rate() {
    let mut random = Random(7);
    for case in 0..4 * times() {
        let (crank, rod) = (random.within(0.1, 0.2), random.within(0.4, 0.6));
        let chain = Chain { rods: vec![(0.8, crank), (0.6, rod)], end: End::Piston(random.within(0.3, 1.0)) };
        let rate = random.within(10.0, 20.0);
        let state = [0.0, 0.0, rate, -rate * crank / rod];
        let truth = Chain::relative(&chain.moved(&state, 0.4)[..2]);
        for (formulation, method) in [("kane", "dop853"), ("lagrange", "dop853"), ("newton-euler", "taylor")] {
            let how = format!("method = \"{method}\"\nrtol = 1e-11\natol = 1e-11");
            let run = by(&chain.scene(&[2], &state, 0.4, &how), formulation);
            assert!(run.failure().is_none(), "case {case}, {formulation}: {:?}", run.objections());
            for (at, angle) in truth.iter().enumerate() {
                near(*run.column_of_quantity(&format!("q{at}")).unwrap().last().unwrap(), *angle, 1e-8, "angle");
            }
        }
        // One rate is enough, since the other follows from it.
        let text = format!("model = \"model.toml\"\nspan = [0, 0.4]\n[start]\nq0 = 0\nq1 = 0\n\"q0'\" = {rate:?}\n");
        let part = scene(
            &chain.model(&[2]),
            &format!("{text}[integration]\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-11\n"),
        );
        near(
            *run(&part, "kane").column_of_quantity("q0").unwrap().last().unwrap(),
            truth[0],
            1e-8,
            "angle by one rate",
        );
        let model =
            tripos_derive::model::load(&tripos_derive::diagnostic::Source::from_text("m.toml", &chain.model(&[2])));
        let by_speed = text.replace(&format!("\"q0'\" = {rate:?}"), "v = 0");
        let refused = Scene::parse(tripos::Mechanism::new(model.unwrap()), &by_speed).err().unwrap().to_string();
        assert!(refused.contains("`v` does not determine") && refused.contains("`q0'`"), "{refused}");
    }
}

/// Goal: a start may state any coordinates that determine a pose, also those that a loop eliminated. Method: poses of
/// random slider-cranks and four-bars, found again from one of their numbers each, with guesses nearby.
#[test]
fn a_pose_follows_from_any_number_that_determines_it() {
    let mut random = Random(3);
    for _ in 0..6 * times() {
        let (chain, state) = turning(&mut random, 2, LastJoint::Piston);
        let angles = Chain::relative(&state[..2]);
        let x: f64 = chain.rods.iter().zip(&state).map(|((_, l), a)| l * a.cos()).sum();
        let guesses = format!("q0 = {:?}\nq1 = {:?}\n", angles[0] + 0.05, angles[1] - 0.1);
        let by_piston = format!("model = \"m.toml\"\nspan = [0, 0.1]\n[start]\nx = {x:?}\nu0 = 1\n[guess]\n{guesses}");
        let by_crank = format!(
            "model = \"m.toml\"\nspan = [0, 0.1]\n[start]\nq0 = {:?}\nu0 = 1\n[guess]\nq1 = {:?}\n",
            angles[0],
            angles[1] - 0.1
        );
        for text in [by_piston, by_crank] {
            let scene = scene(&chain.model(&[0]), &text);
            for (found, angle) in scene.description().q.iter().zip(&angles) {
                near(*found, *angle, 1e-11, "pose");
            }
        }
    }
}

/// Goal: derivatives of a run that replaces its generalized speeds are those of the motion, and the stated errors hold.
/// Method: differences of the chain.
#[test]
fn derivatives_of_runs_that_change_their_speeds_hold() {
    let mut random = Random(12);
    let (chain, state) = turning(&mut random, 2, LastJoint::Piston);
    let how = "method = \"dop853\"\nrtol = 1e-11\natol = 1e-11";
    let scene = chain.scene(&[2], &state, 0.4, how);
    let name = "m0";
    let beside = |by: f64| {
        let mut other = chain.clone();
        other.rods[0].0 += by;
        other.moved(&state, 0.4)[0]
    };
    let h = 1e-3;
    let truth = (8.0 * (beside(h) - beside(-h)) - beside(2.0 * h) + beside(-2.0 * h)) / (12.0 * h);
    let how = Overrides { by: Some("kane".into()), ..Overrides::default() };
    let found = scene.sensitivities(&[name], tripos::DerivativeInstants::End, &how).unwrap();
    let error = found.errors.as_ref().unwrap()[0][0];
    let value = found.derivative_of("q0", name).unwrap();
    assert!((value - truth).abs() < error + 1e-7 && error < 1e-4 * truth.abs().max(1.0), "{value}, {truth}, {error:e}");
    let gradient = scene.gradient("q0", &how).unwrap();
    let slope = gradient.slope_by(name).unwrap();
    assert!((slope.value - truth).abs() < slope.error.unwrap() + 1e-7, "{slope:?}, {truth}");
}

/// Goal: derivatives hold where a run depends on a number by many turns. Method: a crank that turns fast, with a
/// slider, through 22 dead points. Truth: a program of its own, which integrates the crank's equation in its angle.
/// This equation has no dead points.
#[test]
fn derivatives_hold_over_many_turns() {
    let model = r#"
name = "slider154"
[parameters]
g = { unit = "m/s^2", value = 9.81 }
m = { unit = "kg", value = 1.2 }
I = { unit = "kg*m^2", value = 0.1 }
a = { unit = "m", value = 0.45 }
b = { unit = "m", value = 1.12 }
e = { unit = "m", value = -0.01 }
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
x = { unit = "m" }
[speeds]
u2 = "x'"
[inertial]
frame = "N"
origin = "O"
[frames]
B1 = { from = "N", axis = 3, angle = "q1" }
B2 = { from = "N", axis = 3, angle = "q2" }
[points]
A = { from = "O", frame = "B1", position = ["a", 0, 0] }
Q = { from = "A", frame = "B2", position = ["b", 0, 0] }
R = { from = "O", frame = "N", position = ["x", "e", 0] }
C1 = { from = "O", frame = "B1", position = ["a/2", 0, 0] }
C2 = { from = "A", frame = "B2", position = ["b/2", 0, 0] }
[bodies.b1]
frame = "B1"
centre = "C1"
mass = "m"
inertia = "I"
[bodies.b2]
frame = "B2"
centre = "C2"
mass = "m"
inertia = "I"
[particles.sl]
point = "R"
mass = "m"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
lx = { equation = "p(Q) @ N [1] = p(R) @ N [1]" }
ly = { equation = "p(Q) @ N [2] = p(R) @ N [2]" }
"#;
    let text = "span = [0, 0.8]\n[start]\nq2 = 0.401\n\"q2'\" = 1.76\n[guess]\nq1 = -1.82\nx = 1.06\n[integration]\nmethod = \"taylor\"\nrtol = 1e-11\natol = 1e-12\n";
    let scene = crate::driven::scene(model, text);
    for by in ["kane", "lagrange"] {
        let how = Overrides { by: Some(by.into()), ..Overrides::default() };
        let found = scene.sensitivities(&["b"], tripos::DerivativeInstants::End, &how).unwrap();
        for (at, (name, truth)) in [("q1", 2_169.354_3), ("q2", -644.135_9), ("u2", -11_410.741)].iter().enumerate() {
            let (value, error) = (found.derivative_of(name, "b").unwrap(), found.errors.as_ref().unwrap()[0][at]);
            assert!((value - truth).abs() < error + 1e-6 * truth.abs(), "{by}, {name}: {value}, not {truth}");
            assert!(error < 1e-6 * truth.abs(), "{by}, {name}: {error:e}");
        }
    }
}

/// Two pins hold a rod of length a, so that one of the pin's equations has no slope; a second rod swings from its end.
const LOCKED: &str = r#"
name = "locked rod beside a free one"
[inertial]
frame = "N"
origin = "O"
[parameters]
m = "1 kg"
J = "0.01 kg*m^2"
a = "0.3 m"
d = "0.3 m"
g = "9.81 m/s^2"
[bodies]
b0 = { mass = "m", inertia = "J" }
b1 = { mass = "m", inertia = "J" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[joints]
j0 = { kind = "pin", body = "b0", axis = 3, centre = ["a", 0, 0] }
j1 = { kind = "pin", body = "b1", to = "b0", axis = 3, at = ["a", 0, 0], centre = ["a", 0, 0] }
c = { kind = "pin", body = "b0", axis = 3, at = ["d", 0, 0], body_at = ["a", 0, 0] }
"#;

/// Goal: a mechanism runs beside a rod that two pins lock. Method: the free rod is a physical pendulum,
/// (J + m a²) q'' = −m g a cos q; steps of RK4, by every formulation.
#[test]
fn a_rod_swings_from_a_locked_one() {
    let text = "model = \"model.toml\"\nspan = [0, \"0.6 s\"]\n[start]\nq_j1 = 0\n\"q_j1'\" = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-12\n";
    let scene = scene(LOCKED, text);
    let acceleration = |q: f64| -G * 0.3 * q.cos() / (0.01 + 0.09);
    let (mut q, mut u, steps) = (0.0, 0.0, 6000);
    let h = 0.6 / f64::from(steps);
    for _ in 0..steps {
        let (a1, u2) = (acceleration(q), u + h / 2.0 * acceleration(q));
        let (a2, u3) = (acceleration(q + h / 2.0 * u), u + h / 2.0 * acceleration(q + h / 2.0 * u));
        let (a3, u4) = (acceleration(q + h / 2.0 * u2), u + h * acceleration(q + h / 2.0 * u2));
        let a4 = acceleration(q + h * u3);
        q += h / 6.0 * (u + 2.0 * u2 + 2.0 * u3 + u4);
        u += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    for by in ["own", "kane", "lagrange", "newton-euler"] {
        let run = run(&scene, by);
        assert!(run.failure().is_none() && run.objections().is_empty(), "{by}: {:?}", run.objections());
        let angles = run.column_of_quantity("q_j1").unwrap_or_else(|e| panic!("{e}"));
        near(*angles.last().unwrap(), q, 1e-9, by);
    }
}
