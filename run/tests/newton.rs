//! Forces between bodies, checked by Newton's and Euler's laws for each body alone.
//!
//! The mechanisms are random. The forces and torques of each body are those of the bodies to which the generator
//! connected it, and of no others. Its accelerations are differences of its velocities in the run.

use crate::random_trees::times;
use std::fmt::Write;
use tripos::{Error, Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;

/// Time between two samples, s.
const STEP: f64 = 1e-3;
const G: f64 = 9.81;

/// Small generator of numbers (Knuth's linear congruential one).
pub struct Chance(pub u64);

impl Chance {
    pub fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from((self.0 >> 33) % n as u64).unwrap()
    }

    /// Between −1 and 1, in hundredths, and never near 0.
    pub fn number(&mut self) -> f64 {
        let size = 20 + self.below(80);
        f64::from(u32::try_from(size).unwrap()) / 100.0 * if self.below(2) == 0 { 1.0 } else { -1.0 }
    }
}

fn scene(model: &str, start: &[(String, f64)], outputs: &[String]) -> Result<Scene, Error> {
    let mechanism = tripos_derive::model::load(&Source::from_text("model.toml", model));
    let mechanism = mechanism.unwrap_or_else(|error| panic!("{error}\n{model}"));
    let names = outputs.iter().map(|name| format!("{name:?}")).collect::<Vec<_>>().join(", ");
    let start = start.iter().fold(String::new(), |text, (name, value)| format!("{text}{name} = {value}\n"));
    let text = format!(
        "span = [0, {}]\noutputs = [{names}]\n[start]\n{start}[integration]\nsamples = 3\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-13\n",
        2.0 * STEP
    );
    Scene::parse(Mechanism::new(mechanism), &text)
}

/// A run of three samples.
struct Sampled {
    run: Run,
    model: String,
}

impl Sampled {
    fn new(model: &str, start: &[(String, f64)], outputs: &[String]) -> Self {
        let scene = scene(model, start, outputs).unwrap_or_else(|error| panic!("{error}\n{model}"));
        let run = scene.simulate(&Overrides::default()).unwrap_or_else(|error| panic!("{error}\n{model}"));
        Self { run, model: model.to_owned() }
    }

    fn column(&self, name: &str) -> [f64; 3] {
        let column = self.run.column_of_quantity(name).unwrap_or_else(|_| panic!("no {name}\n{}", self.model));
        [column[0], column[column.len() / 2], *column.last().unwrap()]
    }

    /// Value at the middle sample.
    fn value(&self, name: &str) -> f64 {
        self.column(name)[1]
    }

    /// Rate of change at the middle sample.
    fn rate(&self, name: &str) -> f64 {
        let [before, _, after] = self.column(name);
        (after - before) / (2.0 * STEP)
    }

    fn holds(&self, sum: f64, rate: f64, what: &str) {
        assert!((sum - rate).abs() < 2e-4 * (1.0 + sum.abs()), "{what}: {sum}, not {rate}\n{}", self.model);
    }
}

/// Way in which a model file states that a body of a stack lies on the one below.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Lies {
    /// The body is placed from a point of the lower one.
    Placed,
    /// The body rubs on the lower one.
    Rubs,
    /// The contact force is named.
    Named,
    /// The height is a coordinate that a named force holds.
    Enforced,
    /// An equation compares the heights.
    Compared,
    /// An equation compares the heights and names the lower body first.
    Turned,
    /// The heights are coordinates, which an equation compares.
    Related,
    /// Its height is named, and compared with a coordinate.
    Mixed,
    /// The body rolls, and its height is a coordinate.
    Rolls,
    /// The body rolls, and its height is built in.
    RollsBuiltIn,
}

/// Body of a stack: the body below, the way it is stated, and true if it is placed from the origin. `rank` is its index
/// among the bodies of the file.
struct Layer {
    on: Option<usize>,
    lies: Lies,
    is_absolute: bool,
    height: f64,
    rank: usize,
}

impl Layer {
    fn is_ball(&self) -> bool {
        matches!(self.lies, Lies::Rolls | Lies::RollsBuiltIn)
    }

    /// True if an equation compares its height with that of the lower one.
    fn is_compared(&self) -> bool {
        matches!(self.lies, Lies::Compared | Lies::Turned | Lies::Related | Lies::Mixed)
    }

    fn below(&self) -> String {
        self.on.map_or("ground".to_owned(), |at| format!("b{at}"))
    }
}

/// Boards on boards on the ground, up to a ball.
fn stack(chance: &mut Chance) -> Vec<Layer> {
    let mut layers: Vec<Layer> = Vec::new();
    let count = 2 + chance.below(3);
    for at in 0..count {
        let boards: Vec<usize> = (0..at).filter(|lower| !layers[*lower].is_ball()).collect();
        let on = (at > 0).then(|| boards[boards.len() - 1 - chance.below(boards.len().min(2))]);
        let all = [
            Lies::Placed,
            Lies::Rubs,
            Lies::Named,
            Lies::Enforced,
            Lies::Compared,
            Lies::Turned,
            Lies::Related,
            Lies::Mixed,
            Lies::Rolls,
            Lies::RollsBuiltIn,
        ];
        let mut lies = if on.is_some() { all[chance.below(all.len())] } else { Lies::Placed };
        let is_tall = |lower: &Layer| lower.is_absolute && lower.is_compared();
        if matches!(lies, Lies::Related | Lies::Mixed) && !on.is_some_and(|on| is_tall(&layers[on])) {
            lies = Lies::Turned;
        }
        let is_absolute =
            on.is_none() || matches!(lies, Lies::Related | Lies::Mixed) || lies != Lies::Placed && chance.below(2) == 0;
        let height = on.map_or(0.1, |on| layers[on].height + 0.3);
        layers.push(Layer { on, lies, is_absolute, height, rank: 0 });
    }
    let mut ranks: Vec<usize> = (0..count).collect();
    for layer in &mut layers {
        layer.rank = ranks.swap_remove(chance.below(ranks.len()));
    }
    layers
}

/// Boards have masses 1, 2, …, and are pushed by F; bodies have inertia I.
fn stack_text(layers: &[Layer], push: &[f64]) -> String {
    let [mut coordinates, mut speeds, mut frames, mut points, mut rest] = [const { String::new() }; 5];
    let mut bodies = vec![String::new(); layers.len()];
    for (at, layer) in layers.iter().enumerate() {
        let Layer { on, lies, is_absolute, height, rank } = layer;
        writeln!(coordinates, "x{at} = {{ unit = \"m\" }}").unwrap();
        writeln!(speeds, "v{at} = \"x{at}'\"").unwrap();
        let level = match (is_absolute, on) {
            (true, _) | (_, None) => *height,
            (false, Some(on)) => height - layers[*on].height,
        };
        let from = on.filter(|_| !is_absolute).map_or("O".to_owned(), |on| format!("P{on}"));
        let is_compared = layer.is_compared();
        let floats = is_compared || matches!(lies, Lies::Enforced | Lies::Rolls);
        if floats {
            writeln!(coordinates, "y{at} = {{ unit = \"m\" }}").unwrap();
        }
        // A ball touches 0.1 m below its centre.
        let low = if layer.is_ball() { level - 0.1 } else { level };
        let y = match (is_compared, floats) {
            (true, _) => format!("y{at}"),
            (_, true) => format!("y{at} + {low:.2}*m1"),
            _ => format!("{low:.2}*m1"),
        };
        let point = if layer.is_ball() { "C" } else { "P" };
        writeln!(points, "{point}{at} = {{ from = \"{from}\", frame = \"N\", position = [\"x{at}\", \"{y}\", 0] }}")
            .unwrap();
        let mut frame = "N".to_owned();
        if layer.is_ball() {
            writeln!(coordinates, "q{at} = {{ unit = \"rad\" }}").unwrap();
            frame = format!("B{at}");
            writeln!(frames, "{frame} = {{ from = \"N\", axis = 3, angle = \"q{at}\" }}").unwrap();
            writeln!(points, "P{at} = {{ from = \"C{at}\", frame = \"N\", position = [0, \"0.1*m1\", 0] }}").unwrap();
            speeds = speeds.replace(&format!("v{at} = \"x{at}'\""), &format!("v{at} = \"q{at}'\""));
        }
        let mass = at + 1;
        bodies[*rank] =
            format!("[bodies.b{at}]\nframe = \"{frame}\"\ncentre = \"P{at}\"\nmass = \"{mass}*m\"\ninertia = \"I\"\n");
        writeln!(rest, "[forces.F{at}]\non = \"b{at}\"\nframe = \"N\"\nvector = [\"{}*F\", 0, 0]", push[at]).unwrap();
        let Some(on) = on else { continue };
        match lies {
            Lies::Placed => {}
            Lies::Rubs => writeln!(
                rest,
                "[friction.rub{at}]\non = \"b{at}\"\nagainst = \"b{on}\"\ncoefficient = \"mu\"\nnormal_force = \"F\"\nsmoothing = \"s0\"\nframe = \"N\"\nnormal = 2"
            )
            .unwrap(),
            Lies::Named | Lies::Enforced => {
                writeln!(rest, "[reactions.N{at}]\non = \"b{at}\"\nagainst = \"b{on}\"\nframe = \"N\"\ndirection = [0, 1, 0]").unwrap();
                if *lies == Lies::Enforced {
                    writeln!(rest, "[constraints.lies{at}]\nequation = \"y{at} = 0\"\nenforced_by = \"N{at}\"").unwrap();
                }
            }
            Lies::Compared | Lies::Turned | Lies::Related | Lies::Mixed => {
                let rise = height - layers[*on].height;
                let equation = match lies {
                    Lies::Compared => format!("p(P{at}) @ N [2] = p(P{on}) @ N [2] + {rise:.2}*m1"),
                    Lies::Turned => format!("p(P{on}) @ N [2] = p(P{at}) @ N [2] - {rise:.2}*m1"),
                    Lies::Mixed => format!("p(P{at}) @ N [2] = y{on} + {rise:.2}*m1"),
                    _ => format!("y{at} = y{on} + {rise:.2}*m1"),
                };
                writeln!(rest, "[constraints.lies{at}]\nequation = \"{equation}\"").unwrap();
            }
            Lies::Rolls | Lies::RollsBuiltIn => {
                writeln!(rest, "[rolling.roll{at}]\nbody = \"b{at}\"\nat = \"C{at}\"\nagainst = \"b{on}\"").unwrap();
            }
        }
    }
    format!(
        "name = \"stack\"\n[parameters]\nm = \"1 kg\"\nm1 = \"1 m\"\nI = \"0.02 kg*m^2\"\nF = \"3 N\"\nmu = {{ unit = \"1\", value = 0.2 }}\ns0 = \"0.3 m/s\"\ng = \"9.81 m/s^2\"\n[inertial]\n\
         frame = \"N\"\norigin = \"O\"\n[coordinates]\n{coordinates}[speeds]\n{speeds}[frames]\n{frames}[points]\n{points}{}[gravity]\nframe = \"N\"\nacceleration = \
         [0, \"-g\", 0]\n{rest}",
        bodies.concat()
    )
}

/// Friction force of a body on the one below, N along n1.
fn rub(run: &Sampled, layers: &[Layer], at: usize) -> f64 {
    let (Layer { lies: Lies::Rubs, .. }, Some(on)) = (&layers[at], layers[at].on) else { return 0.0 };
    let slip = run.value(&format!("v(P{at}) @ N [1]")) - run.value(&format!("v(P{on}) @ N [1]"));
    -0.6 * slip / slip.hypot(0.3)
}

/// Goal: each body rests on the body that the file names, and the ground carries only the lowest one. Method: random
/// stacks of boards and balls whose contacts are stated in ten ways, placed from the origin or from one another, in
/// any order in the file. For each body the forces of its neighbours in the generator are added up, with friction, and
/// compared with m a and I α.
#[test]
fn stacks_rest_on_what_is_below() {
    let mut chance = Chance(11);
    for case in 0..24 * times() {
        let layers = stack(&mut chance);
        let push: Vec<f64> = layers.iter().map(|_| chance.number()).collect();
        let text = stack_text(&layers, &push);
        let mut start = Vec::new();
        for (at, layer) in layers.iter().enumerate() {
            let x = chance.number();
            start.push((format!("x{at}"), x));
            start.push((format!("v{at}"), chance.number()));
            if layer.is_ball() {
                start.push((format!("q{at}"), chance.number()));
            }
            if layer.lies == Lies::Rolls {
                start.push((format!("y{at}"), 0.0));
            }
        }
        let mut outputs = Vec::new();
        for (at, layer) in layers.iter().enumerate() {
            let below = layer.below();
            outputs.extend([1, 2].map(|axis| format!("v(P{at}) @ N [{axis}]")));
            outputs.extend([1, 2].map(|axis| format!("p(P{at}) @ N [{axis}]")));
            outputs.extend([1, 2].map(|axis| format!("force({below} on b{at}) @ N [{axis}]")));
            outputs.push(format!("torque({below} on b{at} about P{at}) @ N [3]"));
            outputs.push(format!("omega(b{at}) @ N [3]"));
        }
        let run = Sampled::new(&text, &start, &outputs);
        for (at, layer) in layers.iter().enumerate() {
            let what = format!("case {case}, b{at} ({:?})", layer.lies);
            let mass = (at + 1) as f64;
            let below = layer.below();
            let force = |axis: usize, on: usize, by: &str| run.value(&format!("force({by} on b{on}) @ N [{axis}]"));
            let own = [force(1, at, &below) + rub(&run, &layers, at), force(2, at, &below)];
            let mut sum = [own[0] + 3.0 * push[at], own[1] - mass * G];
            let mut moment = run.value(&format!("torque({below} on b{at} about P{at}) @ N [3]"));
            for (upper, _) in layers.iter().enumerate().filter(|(_, other)| other.on == Some(at)) {
                let by = format!("b{at}");
                let felt = [force(1, upper, &by) + rub(&run, &layers, upper), force(2, upper, &by)];
                let [dx, dy] = [1, 2].map(|axis| {
                    run.value(&format!("p(P{upper}) @ N [{axis}]")) - run.value(&format!("p(P{at}) @ N [{axis}]"))
                });
                let twist = run.value(&format!("torque({by} on b{upper} about P{upper}) @ N [3]"));
                sum = [sum[0] - felt[0], sum[1] - felt[1]];
                moment -= twist + dx * felt[1] - dy * felt[0];
            }
            for axis in [1, 2] {
                run.holds(
                    sum[axis - 1],
                    mass * run.rate(&format!("v(P{at}) @ N [{axis}]")),
                    &format!("{what}, force {axis}"),
                );
            }
            run.holds(moment, 0.02 * run.rate(&format!("omega(b{at}) @ N [3]")), &format!("{what}, moment"));
            if layer.on.is_some() {
                let invented = [format!("force(ground on b{at}) @ N [2]")];
                assert!(scene(&text, &start, &invented).is_err(), "{what}: the ground carries it\n{text}");
            }
        }
    }
}

/// Goal: blocks that a rope ties do not rest on one another: pulleys on the ground carry what it pulls. Method: two
/// blocks on tracks along axes of two frames, the rope stated by coordinates, places, rates or a speed. The ground's
/// force on each block is compared with m (a − g).
#[test]
fn pulleys_carry_what_a_rope_ties() {
    let mut chance = Chance(17);
    for case in 0..24 * times() {
        let tracks = [(); 2].map(|()| [("N", 1), ("N", 2), ("A", 1), ("A", 2)][chance.below(4)]);
        let ratio = [1, 2, -2, 3][chance.below(4)];
        let [[one, along], [other, across]] = tracks.map(|(frame, axis)| [frame.to_owned(), axis.to_string()]);
        let mut equation = match chance.below(4) {
            0 => format!("s1 + {ratio}*s2 = L"),
            1 => format!("p(P1) @ {one} [{along}] + {ratio}*p(P2) @ {other} [{across}] = L"),
            2 => format!("s1' + {ratio}*s2' = 0"),
            _ => format!("w + {ratio}*s2' = 0"),
        };
        if chance.below(2) == 0 {
            let (left, right) = equation.split_once(" = ").unwrap();
            equation = format!("{right} = {left}");
        }
        let mut bodies: Vec<String> =
            (1..3).map(|at| format!("[particles.b{at}]\npoint = \"P{at}\"\nmass = \"{at}*m\"\n")).collect();
        if chance.below(2) == 0 {
            bodies.reverse();
        }
        let point = |at: usize| {
            let (frame, axis) = tracks[at - 1];
            let place = if axis == 1 { format!("\"s{at}\", 0") } else { format!("0, \"s{at}\"") };
            format!("P{at} = {{ from = \"O\", frame = \"{frame}\", position = [{place}, 0] }}\n")
        };
        let text = format!(
            "name = \"rope\"\n[parameters]\nm = \"1 kg\"\nL = \"1 m\"\ng = \"9.81 m/s^2\"\nalpha = {{ unit = \"1\", value = 0.4 }}\n\
             [inertial]\nframe = \"N\"\norigin = \"O\"\n[coordinates]\ns1 = {{ unit = \"m\" }}\ns2 = {{ unit = \"m\" }}\n\
             [speeds]\nw = \"s1'\"\n[frames]\nA = {{ from = \"N\", axis = 3, angle = \"alpha\" }}\n[points]\n{}{}{}\
             [gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n[constraints.rope]\nequation = \"{equation}\"\n",
            point(1),
            point(2),
            bodies.concat()
        );
        let model = tripos_derive::model::load(&Source::from_text("model.toml", &text));
        let model = model.unwrap_or_else(|error| panic!("{error}\n{text}"));
        let names = model.coordinates.iter().map(|c| c.name.clone()).chain(["w".to_owned()]);
        let start: Vec<(String, f64)> = names.map(|name| (name, chance.number())).collect();
        let forces = |at: usize| [1, 2].map(|axis| format!("force(ground on b{at}) @ N [{axis}]"));
        let rates = |at: usize| [1, 2].map(|axis| format!("v(P{at}) @ N [{axis}]"));
        let outputs = [forces(1), forces(2), rates(1), rates(2)].concat();
        let run = Sampled::new(&text, &start, &outputs);
        for at in 1..3 {
            for (force, (rate, weight)) in forces(at).iter().zip(rates(at).iter().zip([0.0, G])) {
                let mass = at as f64;
                run.holds(run.value(force) - mass * weight, mass * run.rate(rate), &format!("case {case}, {force}"));
            }
        }
        for invented in ["force(b1 on b2) @ N [2]", "force(b2 on b1) @ N [2]"] {
            assert!(scene(&text, &start, &[invented.to_owned()]).is_err(), "case {case}: {invented}\n{text}");
        }
    }
}

/// Goal: a board rests on the one from which it is placed, not on one further below. Truth: the middle one of three
/// carries the upper one's weight, 3 g, and the lower one carries none of that directly.
#[test]
fn a_board_rests_on_the_nearest_from_which_it_is_placed() {
    let layer = |at: usize| Layer {
        on: at.checked_sub(1),
        lies: Lies::Placed,
        is_absolute: at == 0,
        height: 0.1 + 0.3 * at as f64,
        rank: at,
    };
    let text = stack_text(&[layer(0), layer(1), layer(2)], &[0.5, 0.4, 0.3]);
    let start: Vec<(String, f64)> = ["x0", "x1", "x2", "v0", "v1", "v2"].map(|name| (name.to_owned(), 0.2)).to_vec();
    let run =
        Sampled::new(&text, &start, &["force(b1 on b2) @ N [2]".to_owned(), "force(b0 on b1) @ N [2]".to_owned()]);
    run.holds(run.value("force(b1 on b2) @ N [2]"), 3.0 * G, "the upper one");
    run.holds(run.value("force(b0 on b1) @ N [2]"), 5.0 * G, "the middle one");
    let message = scene(&text, &start, &["force(b0 on b2) @ N [2]".to_owned()]).err().unwrap().to_string();
    assert!(message.contains("no reaction acts between `b0` and `b2`"), "{message}");
}

/// Goal: the joint forces balance each body, screws among them. Method: random chains of pins, sliders, screws,
/// cylinders and universal joints in space. m a and dH/dt about each mass centre are compared with the forces and
/// torques of the joints at both ends.
#[test]
fn joints_balance_each_body() {
    let mut chance = Chance(3);
    for case in 0..12 * times() {
        let count = 1 + chance.below(3);
        let [mut bodies, mut joints] = [const { String::new() }; 2];
        let (mut start, mut outputs, mut ons) = (Vec::new(), Vec::new(), Vec::new());
        for at in 0..count {
            // Each chain has a screw.
            let kind = if at == case % count {
                "screw"
            } else {
                ["pin", "slider", "screw", "cylinder", "universal"][chance.below(5)]
            };
            let on = (at > 0).then(|| at - 1 - chance.below(at.min(2)));
            let to = on.map_or(String::new(), |on| format!("to = \"b{on}\"\nat = [\"l\", \"l/3\", \"-l/2\"]\n"));
            let lead = if kind == "screw" { "lead = \"l/4\"\n" } else { "" };
            let axis = if kind == "universal" {
                "axes = [1, 2]\n".to_owned()
            } else {
                format!("axis = {}\n", 1 + chance.below(3))
            };
            writeln!(
                bodies,
                "b{at} = {{ mass = \"{}*m\", inertia = {{ diagonal = [\"2*I\", \"3*I\", \"4*I\"] }} }}",
                at + 1
            )
            .unwrap();
            writeln!(joints, "[joints.J{at}]\nkind = \"{kind}\"\nbody = \"b{at}\"\n{to}{axis}{lead}centre = [\"l/5\", \"l\", \"l/2\"]").unwrap();
            let names: &[&str] = if ["cylinder", "universal"].contains(&kind) { &["_1", "_2"] } else { &[""] };
            for end in names {
                start.push((format!("q_J{at}{end}"), chance.number()));
                start.push((format!("u_J{at}{end}"), chance.number()));
            }
            let below = on.map_or("ground".to_owned(), |on| format!("b{on}"));
            for axis in 1..=3 {
                outputs.push(format!("v(b{at}_centre) @ N [{axis}]"));
                outputs.push(format!("omega(b{at}) @ b{at}_frame [{axis}]"));
                outputs.push(format!("force({below} on b{at}) @ N [{axis}]"));
                outputs.push(format!("torque({below} on b{at} about b{at}_centre) @ b{at}_frame [{axis}]"));
                if let Some(on) = on {
                    outputs.push(format!("torque(b{at} on b{on} about b{on}_centre) @ b{on}_frame [{axis}]"));
                }
            }
            ons.push(on);
        }
        let text = format!(
            "name = \"chain\"\n[parameters]\nm = \"1 kg\"\nl = \"0.5 m\"\nI = \"0.1 kg*m^2\"\ng = \"9.81 m/s^2\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[gravity]\nframe = \
             \"N\"\nacceleration = [\"g/3\", \"-g\", \"g/2\"]\n[bodies]\n{bodies}{joints}"
        );
        let run = Sampled::new(&text, &start, &outputs);
        for (at, on) in ons.iter().enumerate() {
            let what = format!("case {case}, b{at}");
            let below = on.map_or("ground".to_owned(), |on| format!("b{on}"));
            let uppers: Vec<usize> = (0..count).filter(|upper| ons[*upper] == Some(at)).collect();
            let inertia = [0.2, 0.3, 0.4];
            let omega = [1, 2, 3].map(|axis| run.value(&format!("omega(b{at}) @ b{at}_frame [{axis}]")));
            for axis in 1..=3 {
                let mass = (at + 1) as f64;
                let mut sum = run.value(&format!("force({below} on b{at}) @ N [{axis}]"))
                    + mass * [G / 3.0, -G, G / 2.0][axis - 1];
                let mut moment =
                    run.value(&format!("torque({below} on b{at} about b{at}_centre) @ b{at}_frame [{axis}]"));
                for upper in &uppers {
                    sum -= run.value(&format!("force(b{at} on b{upper}) @ N [{axis}]"));
                    moment +=
                        run.value(&format!("torque(b{upper} on b{at} about b{at}_centre) @ b{at}_frame [{axis}]"));
                }
                run.holds(
                    sum,
                    mass * run.rate(&format!("v(b{at}_centre) @ N [{axis}]")),
                    &format!("{what}, force {axis}"),
                );
                let (i, j, k) = (axis - 1, axis % 3, (axis + 1) % 3);
                let spin = inertia[i] * run.rate(&format!("omega(b{at}) @ b{at}_frame [{axis}]"))
                    + (inertia[k] - inertia[j]) * omega[j] * omega[k];
                run.holds(moment, spin, &format!("{what}, moment {axis}"));
            }
        }
    }
}
