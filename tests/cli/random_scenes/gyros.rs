//! Random trees of turns and slides: tops and gyros in Euler's and Cardan's angles, rotors, chains and planar
//! mechanisms, with a motion that is computed without Tripos.
//!
//! The independent motion: M(q) = Σ m Jᵀ J + Jᵀ I J with the Jacobians of each body from rotation matrices, and
//! Lagrange's equations M q̈ = Q − Ṁ q̇ + ½ ∂(q̇ᵀ M q̇)/∂q with ∂M/∂q by differences of fourth order, integrated by
//! DOP853.

use crate::spoilt::Random;
use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, Unit, Vector3};
use std::fmt::Write;
use tripos_sim::{Failure, Method, Options, OutputOption, integrate};

/// A step for ∂M/∂q, rad or m.
const STEP: f64 = 1e-3;
/// Least distance of angles from their singularity: the sine or cosine of the middle angle.
const CLEAR: f64 = 0.25;
/// The constant turn of a body that slides, so that no two bodies share a frame.
const TILT: f64 = 0.3;

/// A number, as the file says it and as it is.
#[derive(Clone)]
struct Number {
    text: String,
    value: f64,
}

impl Number {
    fn zero() -> Self {
        Self { text: "0".to_owned(), value: 0.0 }
    }
}

/// A coordinate: a turn about an axis of the frame before, or a way along it.
struct Step {
    /// The step that it starts from; nothing for the ground.
    before: Option<usize>,
    axis: usize,
    is_turn: bool,
    /// Origin of the step, in the frame before.
    at: [Number; 3],
    body: Option<Body>,
    /// A torque or a force −c q' along the axis, on the body.
    drag: Option<Number>,
    /// A torque or a force −k q along the axis, on the body.
    spring: Option<Number>,
}

struct Body {
    mass: Number,
    /// Principal moments.
    inertia: [Number; 3],
    centre: [Number; 3],
    /// Drag −c v at the mass centre, along the inertial axes.
    drag: Option<Number>,
}

/// Kind of the generalized speeds of three turns in a row.
#[derive(Clone, Copy)]
enum Speeds {
    Rates,
    /// Components of the angular velocity in the last frame, or in the one before it.
    Body,
    Leaning,
}

pub struct Gyro {
    steps: Vec<Step>,
    parameters: Vec<(String, &'static str, f64)>,
    /// The first of three turns whose speeds are those, if there are such.
    triple: Option<(usize, Speeds)>,
    /// The inertial axis that gravity is against.
    gravity: Option<usize>,
    start: Vec<f64>,
    outputs: Vec<String>,
    pub span: f64,
}

const G: f64 = 9.81;

/// The step of a body, the Jacobians of its mass centre and of its turning, and its inertia or frame.
type Jacobians = (usize, DMatrix<f64>, DMatrix<f64>, Matrix3<f64>);

impl Gyro {
    /// A mechanism with a motion that stays clear of its own singular poses for a while; nothing if it does not.
    pub fn new(random: &mut Random) -> Option<Self> {
        let mut gyro = Self {
            steps: Vec::new(),
            parameters: vec![("g".to_owned(), "m/s^2", G), ("tilt".to_owned(), "1", TILT)],
            triple: None,
            gravity: random.chance(60).then(|| random.below(3)),
            start: Vec::new(),
            outputs: Vec::new(),
            span: 0.8,
        };
        match random.below(4) {
            0 | 1 => gyro.top(random),
            2 => gyro.rotor(random),
            _ => gyro.planar(random),
        }
        let n = gyro.steps.len();
        let rates = (0..n).map(|_| random.decimal(-1.5, 1.5)).collect::<Vec<_>>();
        gyro.start.extend(rates);
        if gyro.triple.is_some() && random.chance(50) {
            // A fast spin.
            gyro.start[2 * n - 1] = random.decimal(3.0, 8.0);
        }
        let names: Vec<String> = (0..n).flat_map(|i| [format!("q{i}"), format!("q{i}'")]).collect();
        if random.chance(75) {
            let count = 1 + random.below(2);
            gyro.outputs = (0..count).map(|_| random.one(&names).clone()).collect();
            gyro.outputs.sort();
            gyro.outputs.dedup();
        }
        gyro.span = gyro.clear_until();
        (gyro.span > 0.2).then_some(gyro)
    }

    /// One body that turns about a point which is fixed, or moves freely.
    fn top(&mut self, random: &mut Random) {
        let is_free = random.chance(40);
        for axis in 0..if is_free { 3 } else { 0 } {
            self.step(axis, false);
        }
        let middle = self.turns(random);
        let last = self.steps.len() - 1;
        let along = random.below(3);
        let mut centre = [(); 3].map(|()| Number::zero());
        if !is_free && random.chance(70) {
            centre[along] = self.named("l", "m", random.decimal(0.1, 0.4));
        }
        let mut body = self.body(random, centre);
        body.drag = (is_free && random.chance(50)).then(|| self.named("c", "N*s/m", random.decimal(0.2, 0.9)));
        self.steps[last].body = Some(body);
        self.steps[last].drag = random.chance(30).then(|| self.named("c", "N*m*s", random.decimal(0.05, 0.3)));
        self.start = (0..=last).map(|_| random.decimal(-0.8, 0.8)).collect();
        self.start[last - 1] = middle;
        let speeds = *random.one(&[Speeds::Rates, Speeds::Body, Speeds::Leaning]);
        self.triple = Some((last - 2, speeds));
    }

    /// A rotor in rings that have mass.
    fn rotor(&mut self, random: &mut Random) {
        let middle = self.turns(random);
        for at in 0..3 {
            let body = self.body(random, [(); 3].map(|()| Number::zero()));
            self.steps[at].body = Some(body);
            self.steps[at].drag = random.chance(20).then(|| self.named("c", "N*m*s", random.decimal(0.05, 0.3)));
            let has_spring = at < 2 && random.chance(20);
            self.steps[at].spring = has_spring.then(|| self.named("k", "N*m", random.decimal(0.5, 2.0)));
        }
        self.start = (0..3).map(|_| random.decimal(-0.8, 0.8)).collect();
        self.start[1] = middle;
        self.triple = Some((0, Speeds::Rates));
    }

    /// Bodies in a plane, on one another or on the ground.
    fn planar(&mut self, random: &mut Random) {
        let axis = random.below(3);
        let count = 2 + random.below(3);
        for at in 0..count {
            let is_turn = at == 0 || random.chance(50);
            let along = if is_turn { axis } else { (axis + 1 + random.below(2)) % 3 };
            let before = (at > 0).then(|| if random.chance(60) { at - 1 } else { random.below(at) });
            self.step(along, is_turn);
            let [mut centre, mut start] = [(); 2].map(|()| [(); 3].map(|()| Number::zero()));
            centre[(axis + 1) % 3] = self.named("l", "m", random.decimal(0.05, 0.4));
            if at > 0 {
                start[(axis + 1) % 3] = self.named("l", "m", random.decimal(0.05, 0.4));
            }
            let mut body = self.body(random, centre);
            body.drag = random.chance(15).then(|| self.named("c", "N*s/m", random.decimal(0.2, 0.9)));
            let [lost, pulled] = if is_turn { ["N*m*s", "N*m"] } else { ["N*s/m", "N/m"] };
            let drag = random.chance(20).then(|| self.named("c", lost, random.decimal(0.05, 0.3)));
            let spring = random.chance(20).then(|| self.named("k", pulled, random.decimal(1.0, 5.0)));
            let step = &mut self.steps[at];
            (step.before, step.at, step.body, step.drag, step.spring) = (before, start, Some(body), drag, spring);
        }
        self.start = (0..count).map(|_| random.decimal(-0.9, 0.9)).collect();
    }

    fn step(&mut self, axis: usize, is_turn: bool) {
        let before = self.steps.len().checked_sub(1);
        let at = [(); 3].map(|()| Number::zero());
        self.steps.push(Step { before, axis, is_turn, at, body: None, drag: None, spring: None });
    }

    /// A parameter of its own for a number.
    fn named(&mut self, letter: &str, unit: &'static str, value: f64) -> Number {
        let text = format!("{letter}{}", self.parameters.len());
        self.parameters.push((text.clone(), unit, value));
        Number { text, value }
    }

    /// Three turns, Euler's or Cardan's; a middle angle far from where they are singular.
    fn turns(&mut self, random: &mut Random) -> f64 {
        let first = random.below(3);
        let second = (first + 1 + random.below(2)) % 3;
        let is_euler = random.chance(60);
        let third = if is_euler { first } else { 3 - first - second };
        for axis in [first, second, third] {
            self.step(axis, true);
        }
        if is_euler { random.decimal(0.7, 2.2) } else { random.decimal(-0.7, 0.7) }
    }

    /// A body whose moments may be equal, as letters or as multiples of one. Any two of them are more than the third.
    fn body(&mut self, random: &mut Random, centre: [Number; 3]) -> Body {
        let number = self.parameters.len();
        let values = if random.chance(40) {
            *random.one(&[[0.5, 0.75, 0.75], [1.0, 0.75, 0.5], [0.75, 0.5, 0.5], [1.5, 1.0, 1.25]])
        } else {
            [(); 3].map(|()| random.decimal(0.3, 0.55))
        };
        let equal = *random.one(&[[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, 0], [0, 1, 2], [0, 0, 1]]);
        let are_letters = random.chance(70);
        let inertia = equal.map(|which: usize| {
            let text = if are_letters {
                format!("I{number}{}", ["a", "b", "c"][which])
            } else {
                format!("{}*J", values[which])
            };
            Number { text, value: values[which] }
        });
        let letters = inertia.iter().map(|moment| (moment.text.clone(), moment.value));
        let unit = ("J".to_owned(), 1.0);
        for (name, value) in letters.filter(|_| are_letters).chain([unit]) {
            if self.parameters.iter().all(|(known, ..)| *known != name) {
                self.parameters.push((name, "kg*m^2", value));
            }
        }
        let mass = if random.chance(40) { 2.0 } else { random.decimal(0.4, 2.5) };
        Body { mass: self.named("m", "kg", mass), inertia, centre, drag: None }
    }

    /// Frame and origin of each step.
    fn places(&self, q: &[f64]) -> Vec<(Matrix3<f64>, Vector3<f64>)> {
        let mut places: Vec<(Matrix3<f64>, Vector3<f64>)> = Vec::new();
        for (step, q) in self.steps.iter().zip(q) {
            let (frame, origin) = step.before.map_or((Matrix3::identity(), Vector3::zeros()), |at| places[at]);
            let mut at = Vector3::from_fn(|k, _| step.at[k].value);
            let turn = |axis: usize, angle: f64| {
                Rotation3::from_axis_angle(&Unit::new_normalize(Vector3::ith(axis, 1.0)), angle).into_inner()
            };
            let own = if step.is_turn {
                turn(step.axis, *q)
            } else {
                at[step.axis] += q;
                if step.body.is_some() { turn(0, TILT) } else { Matrix3::identity() }
            };
            places.push((frame * own, origin + frame * at));
        }
        places
    }

    /// True if the step `other` is `step` or is carried by it.
    fn carries(&self, step: usize, mut other: usize) -> bool {
        while other != step {
            match self.steps[other].before {
                Some(before) => other = before,
                None => return false,
            }
        }
        true
    }

    /// Jacobians of the mass centre and of the turning of each body, with its step.
    fn jacobians(&self, q: &[f64]) -> Vec<Jacobians> {
        let (n, places) = (self.steps.len(), self.places(q));
        let of = |at: usize, body: &Body| {
            let (frame, origin) = places[at];
            let centre = origin + frame * Vector3::from_fn(|k, _| body.centre[k].value);
            let (mut way, mut turn) = (DMatrix::zeros(3, n), DMatrix::zeros(3, n));
            for (k, step) in self.steps.iter().enumerate().filter(|(k, _)| self.carries(*k, at)) {
                let before = step.before.map_or(Matrix3::identity(), |b| places[b].0);
                let axis = before.column(step.axis).into_owned();
                if step.is_turn {
                    turn.set_column(k, &axis);
                    way.set_column(k, &axis.cross(&(centre - places[k].1)));
                } else {
                    way.set_column(k, &axis);
                }
            }
            (at, way, turn, frame)
        };
        self.steps.iter().enumerate().filter_map(|(at, step)| Some(of(at, step.body.as_ref()?))).collect()
    }

    fn body_of(&self, at: usize) -> &Body {
        self.steps[at].body.as_ref().expect("a body")
    }

    fn mass_matrix(&self, q: &[f64]) -> DMatrix<f64> {
        let n = q.len();
        self.jacobians(q).into_iter().fold(DMatrix::zeros(n, n), |sum, (at, way, turn, frame)| {
            let body = self.body_of(at);
            let inertia = Matrix3::from_diagonal(&Vector3::from_fn(|i, _| body.inertia[i].value));
            let inertia = frame * inertia * frame.transpose();
            sum + body.mass.value * way.transpose() * &way + turn.transpose() * inertia * &turn
        })
    }

    fn forces(&self, q: &[f64], rates: &DVector<f64>) -> DVector<f64> {
        let mut sum = DVector::zeros(q.len());
        for (at, way, ..) in self.jacobians(q) {
            let body = self.body_of(at);
            if let Some(axis) = self.gravity {
                sum -= body.mass.value * G * way.row(axis).transpose();
            }
            if let Some(c) = &body.drag {
                sum -= c.value * way.transpose() * (&way * rates);
            }
        }
        for (at, step) in self.steps.iter().enumerate() {
            let value = |number: &Option<Number>| number.as_ref().map_or(0.0, |number| number.value);
            let law = -value(&step.drag) * rates[at] - value(&step.spring) * q[at];
            if law == 0.0 {
                continue;
            }
            // The load is on the body from the ground: it works on all that the axis moves along.
            let (places, (_, way, turn, frame)) = (
                self.places(q),
                self.jacobians(q).into_iter().find(|(body, ..)| *body == at).expect("loads are on bodies"),
            );
            let before = step.before.map_or(Matrix3::identity(), |b| places[b].0);
            let axis = law * if step.is_turn { frame.column(step.axis) } else { before.column(step.axis) };
            sum += if step.is_turn { turn.transpose() * axis } else { way.transpose() * axis };
        }
        sum
    }

    /// Accelerations q̈ by Lagrange's equations.
    fn accelerations(&self, q: &[f64], rates: &[f64]) -> DVector<f64> {
        let v = DVector::from_column_slice(rates);
        let mut right = self.forces(q, &v);
        for (k, rate) in rates.iter().enumerate() {
            let beside = |h: f64| {
                let mut q = q.to_vec();
                q[k] += h;
                self.mass_matrix(&q)
            };
            let slope =
                (8.0 * (beside(STEP) - beside(-STEP)) - (beside(2.0 * STEP) - beside(-2.0 * STEP))) / (12.0 * STEP);
            let by_v = &slope * &v;
            right -= *rate * &by_v;
            right[k] += 0.5 * v.dot(&by_v);
        }
        self.mass_matrix(q).cholesky().expect("a mass matrix").solve(&right)
    }

    /// (q, q̇) at these instants.
    pub fn motion(&self, instants: &[f64]) -> Vec<Vec<f64>> {
        let n = self.steps.len();
        let rhs = |_: f64, y: &[f64], dy: &mut [f64]| {
            let (q, rates) = y.split_at(n);
            dy[..n].copy_from_slice(rates);
            dy[n..].copy_from_slice(self.accelerations(q, rates).as_slice());
            Ok::<(), Failure>(())
        };
        let options = Options {
            method: Method::Dop853,
            output: OutputOption::At(instants.to_vec()),
            ..Options::tolerances(1e-11, 1e-11)
        };
        let end = instants.last().copied().expect("an instant");
        integrate(rhs, (0.0, end), &self.start, &options, &mut []).expect("a motion").y
    }

    /// Until when the middle one of three turns stays clear of where they are singular.
    fn clear_until(&self) -> f64 {
        let Some((first, _)) = self.triple else { return self.span };
        let is_euler = self.steps[first].axis == self.steps[first + 2].axis;
        let instants: Vec<f64> = (0..=40).map(|k| self.span * f64::from(k) / 40.0).collect();
        let near = |y: &Vec<f64>| {
            let middle = y[first + 1];
            (if is_euler { middle.sin() } else { middle.cos() }).abs() < CLEAR
        };
        let first = self.motion(&instants).iter().position(near);
        first.map_or(self.span, |at| instants[at.saturating_sub(1)])
    }

    /// Definitions of the speeds.
    fn speeds(&self) -> Vec<String> {
        let mut list: Vec<String> = (0..self.steps.len()).map(|i| format!("q{i}'")).collect();
        let Some((first, speeds)) = self.triple else { return list };
        let (a, b, c) = (first, first + 1, first + 2);
        // The components of a unit vector along the axis of one step, seen after the turns that follow.
        let seen = |of: usize, turns: &[usize]| {
            let mut parts = [String::from("0"), String::from("0"), String::from("0")];
            "1".clone_into(&mut parts[self.steps[of].axis]);
            for turn in turns {
                let (i, j) = ((self.steps[*turn].axis + 1) % 3, (self.steps[*turn].axis + 2) % 3);
                let (x, y) = (parts[i].clone(), parts[j].clone());
                parts[i] = format!("(cos(q{turn})*({x}) + sin(q{turn})*({y}))");
                parts[j] = format!("(cos(q{turn})*({y}) - sin(q{turn})*({x}))");
            }
            parts
        };
        let of = match speeds {
            Speeds::Rates => return list,
            Speeds::Body => [seen(a, &[b, c]), seen(b, &[c]), seen(c, &[])],
            Speeds::Leaning => [seen(a, &[b]), seen(b, &[]), seen(c, &[])],
        };
        for k in 0..3 {
            list[first + k] = format!("q{a}'*{} + q{b}'*{} + q{c}'*{}", of[0][k], of[1][k], of[2][k]);
        }
        list
    }

    /// The frame that a step leads to: one of its own for a turn or a body.
    fn frame(&self, at: usize) -> String {
        let step = &self.steps[at];
        if step.is_turn || step.body.is_some() {
            return format!("F{at}");
        }
        step.before.map_or_else(|| "N".to_owned(), |before| self.frame(before))
    }

    pub fn model(&self) -> String {
        let [mut coordinates, mut speeds, mut frames, mut points, mut bodies, mut loads] = [const { String::new() }; 6];
        let vector = |axis: usize, law: &str| {
            let parts: Vec<String> =
                (0..3).map(|k| if k == axis { format!("\"{law}\"") } else { "0".to_owned() }).collect();
            parts.join(", ")
        };
        for ((i, step), speed) in self.steps.iter().enumerate().zip(self.speeds()) {
            let unit = if step.is_turn { "rad" } else { "m" };
            let _ = writeln!(coordinates, "q{i} = {{ unit = \"{unit}\" }}");
            let _ = writeln!(speeds, "u{i} = \"{speed}\"");
            let frame = step.before.map_or("N".to_owned(), |before| self.frame(before));
            let point = step.before.map_or("O".to_owned(), |before| format!("P{before}"));
            let way = |k: usize| if !step.is_turn && k == step.axis { format!(" + q{i}") } else { String::new() };
            let at: Vec<String> = (0..3).map(|k| format!("\"{}{}\"", step.at[k].text, way(k))).collect();
            let _ = writeln!(
                points,
                "P{i} = {{ from = \"{point}\", frame = \"{frame}\", position = [{}] }}",
                at.join(", ")
            );
            let (axis, angle) = if step.is_turn { (step.axis, format!("q{i}")) } else { (0, "tilt".to_owned()) };
            if step.is_turn || step.body.is_some() {
                let _ = writeln!(frames, "F{i} = {{ from = \"{frame}\", axis = {}, angle = \"{angle}\" }}", axis + 1);
            }
            let Some(body) = &step.body else { continue };
            let of = |list: &[Number; 3]| list.iter().map(|number| number.text.clone()).collect::<Vec<_>>();
            let (centre, diagonal) = (of(&body.centre), of(&body.inertia));
            let _ = writeln!(points, "C{i} = {{ from = \"P{i}\", frame = \"F{i}\", position = {centre:?} }}");
            let _ = writeln!(
                bodies,
                "[bodies.B{i}]\nframe = \"F{i}\"\ncentre = \"C{i}\"\nmass = \"{}\"\ninertia = {{ diagonal = {diagonal:?} }}",
                body.mass.text
            );
            let own = if step.is_turn { format!("F{i}") } else { frame };
            for (name, law, c) in [("d", format!("q{i}'"), &step.drag), ("s", format!("q{i}"), &step.spring)] {
                let Some(Number { text: c, .. }) = c else { continue };
                let kind = if step.is_turn { "torques" } else { "forces" };
                let law = vector(step.axis, &format!("-{c}*{law}"));
                let _ = writeln!(loads, "[{kind}.{name}{i}]\non = \"B{i}\"\nframe = \"{own}\"\nvector = [{law}]");
            }
            if let Some(Number { text: c, .. }) = &body.drag {
                let law: Vec<String> = (1..=3).map(|k| format!("\"-{c}*v(C{i}) @ N [{k}]\"")).collect();
                let _ = writeln!(loads, "[forces.air{i}]\non = \"B{i}\"\nframe = \"N\"\nvector = [{}]", law.join(", "));
            }
        }
        let lines = self.parameters.iter();
        let lines = lines.map(|(name, unit, value)| format!("{name} = {{ unit = \"{unit}\", value = {value} }}\n"));
        let parameters = lines.collect::<Vec<_>>().concat();
        let gravity = self.gravity.map_or(String::new(), |axis| {
            format!("[gravity]\nframe = \"N\"\nacceleration = [{}]\n", vector(axis, "-g"))
        });
        format!(
            "name = \"Gyro\"\n[parameters]\n{parameters}[coordinates]\n{coordinates}[speeds]\n{speeds}[inertial]\nframe = \"N\"\norigin = \"O\"\n\
             [frames]\n{frames}[points]\n{points}{bodies}{gravity}{loads}"
        )
    }

    pub fn scene(&self) -> String {
        let n = self.steps.len();
        let lines = self.start.iter().enumerate();
        let lines = lines.map(|(at, x)| format!("\"q{}{}\" = {x}\n", at % n, if at < n { "" } else { "'" }));
        let start = lines.collect::<Vec<_>>().concat();
        let outputs = if self.outputs.is_empty() { String::new() } else { format!("outputs = {:?}\n", self.outputs) };
        format!(
            "model = \"model.toml\"\nspan = [0, {}]\n{outputs}[start]\n{start}[integration]\nmethod = \"dop853\"\nrtol = 1e-11\natol = 1e-11\n",
            self.span
        )
    }

    /// Right values of the scene's outputs at the end, coordinates and rates, by name.
    pub fn right(&self) -> Vec<(String, f64)> {
        let end = self.motion(&[self.span]).pop().expect("an end");
        let n = self.steps.len();
        let all = (0..2 * n).map(|at| (format!("q{}{}", at % n, if at < n { "" } else { "'" }), end[at]));
        let shows = |name: &String| {
            if self.outputs.is_empty() { !name.ends_with('\'') } else { self.outputs.contains(name) }
        };
        all.filter(|(name, _)| shows(name)).collect()
    }
}
