//! Random trees of bodies over all kinds of joints, and their accelerations from first principles.
//!
//! [`Tree::text`] is the model file. [`Tree::accelerations`] shares nothing with Tripos: rotations and places are
//! computed as Taylor polynomials in time, velocities and accelerations are read off, and Σ m (a − g)·∂v/∂q̇ +
//! (I α + ω × I ω)·∂ω/∂q̇ = Q is solved densely (T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications*
//! (1985), §6.1).
#![allow(dead_code, reason = "each test program uses its part")]

use super::random::Random;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use std::fmt::Write;
use std::ops::{Add, Mul};

/// Acceleration of free fall along −axis 3, m/s².
const GRAVITY: f64 = 9.81;

/// a + b t + c t², in whatever a, b and c are.
#[derive(Clone, Copy, Debug)]
struct Jet([f64; 3]);

impl Jet {
    const ZERO: Self = Self([0.0; 3]);

    fn constant(a: f64) -> Self {
        Self([a, 0.0, 0.0])
    }

    /// (cos, sin).
    fn circle(self) -> (Self, Self) {
        let [a, b, c] = self.0;
        let (s, k) = a.sin_cos();
        (Self([k, -s * b, -s * c - k * b * b / 2.0]), Self([s, k * b, k * c - s * b * b / 2.0]))
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self.0[i] + other.0[i]))
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a * x, a * y + b * x, a * z + b * y + c * x])
    }
}

type Turn = [[Jet; 3]; 3];

fn about(axis: usize, angle: Jet) -> Turn {
    let (cosine, sine) = angle.circle();
    let minus = Jet::constant(-1.0) * sine;
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turn = [[Jet::ZERO; 3]; 3];
    turn[axis][axis] = Jet::constant(1.0);
    (turn[j][j], turn[k][k], turn[j][k], turn[k][j]) = (cosine, cosine, minus, sine);
    turn
}

fn times(a: &Turn, b: &Turn) -> Turn {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).fold(Jet::ZERO, |sum, k| sum + a[i][k] * b[k][j])))
}

fn turned(a: &Turn, x: [Jet; 3]) -> [Jet; 3] {
    [0, 1, 2].map(|i| (0..3).fold(Jet::ZERO, |sum, k| sum + a[i][k] * x[k]))
}

fn part(turn: &Turn, order: usize) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| turn[i][j].0[order])
}

/// (ω, α) in the frame that a rotation leads from, from R(t) = R₀ + R₁ t + R₂ t²: the axial vectors of Ṙ Rᵀ and its
/// rate.
fn spin(turn: &Turn) -> (Vector3<f64>, Vector3<f64>) {
    let [r0, r1, r2] = [0, 1, 2].map(|order| part(turn, order));
    let axial =
        |m: Matrix3<f64>| Vector3::new(m[(2, 1)] - m[(1, 2)], m[(0, 2)] - m[(2, 0)], m[(1, 0)] - m[(0, 1)]) / 2.0;
    (axial(r1 * r0.transpose()), axial(2.0 * r2 * r0.transpose() + r1 * r1.transpose()))
}

/// One coordinate of a joint.
#[derive(Clone, Copy, PartialEq)]
enum JointMotion {
    Along(usize),
    About(usize),
    /// About an axis and along it by so many metres each turn.
    Screwed(usize, f64),
}

struct Link {
    kind: &'static str,
    /// Keys of the joint beside its kind.
    keys: String,
    ways: Vec<JointMotion>,
    /// True if the speeds of the last three coordinates are components of the relative angular velocity.
    is_ball: bool,
    parent: Option<usize>,
    at: [f64; 3],
    centre: [f64; 3],
    mass: f64,
    inertia: Matrix3<f64>,
    /// Stiffness and damping in the joint, of joints with one coordinate that turns or slides.
    spring: Option<(f64, f64)>,
}

/// The scene file of a run from this state, of a model file called `model.toml`, until this instant.
pub fn scene(q: &[f64], u: &[f64], end: f64) -> String {
    let mut text = format!("model = \"model.toml\"\nspan = [0, {end}]\n[start]\n");
    for (at, (q, u)) in q.iter().zip(u).enumerate() {
        let _ = writeln!(text, "q{at} = {q}\nu{at} = {u}");
    }
    text + "[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-13\n"
}

/// A tree of one to five bodies.
pub struct Tree {
    links: Vec<Link>,
}

impl Tree {
    /// With so many bodies; all numbers are short decimals.
    pub fn new(random: &mut Random, count: usize) -> Self {
        Self { links: (0..count).map(|at| Link::new(random, at)).collect() }
    }

    /// Coordinates of all joints, in order.
    pub fn coordinates(&self) -> usize {
        self.links.iter().map(|link| link.ways.len()).sum()
    }

    /// The kinds of its joints, for messages.
    pub fn kinds(&self) -> String {
        self.links.iter().map(|link| link.kind).collect::<Vec<_>>().join(", ")
    }

    /// A state away from the poles of all sequences: coordinates and speeds.
    pub fn state(&self, random: &mut Random) -> (Vec<f64>, Vec<f64>) {
        let n = self.coordinates();
        let q = (0..n).map(|_| random.decimal(0.3, 1.1)).collect();
        (q, (0..n).map(|_| random.decimal(-1.0, 1.0)).collect())
    }

    /// The model file; coordinates are called q0, q1, …, speeds u0, u1, ….
    pub fn text(&self) -> String {
        let mut parameters = format!("g = {{ unit = \"m/s^2\", value = {GRAVITY} }}\n");
        let (mut bodies, mut joints, mut loads) = (String::new(), String::new(), String::new());
        let mut first = 0;
        for (at, link) in self.links.iter().enumerate() {
            let mut number = |name: String, unit: &str, value: f64| {
                let _ = writeln!(parameters, "{name} = {{ unit = \"{unit}\", value = {value} }}");
                name
            };
            let mass = number(format!("m{at}"), "kg", link.mass);
            let mut moment = |name: &str, i: usize, j: usize| {
                format!("\"{}\"", number(format!("{name}{at}"), "kg*m^2", link.inertia[(i, j)]))
            };
            let diagonal = [moment("A", 0, 0), moment("B", 1, 1), moment("C", 2, 2)].join(", ");
            let products = [moment("D", 0, 1), moment("E", 1, 2), moment("F", 0, 2)].join(", ");
            let _ = writeln!(
                bodies,
                "b{at} = {{ mass = \"{mass}\", inertia = {{ diagonal = [{diagonal}], products = [{products}] }} }}"
            );
            let mut place = |name: &str, list: [f64; 3]| {
                let names = [0, 1, 2].map(|k| match list[k] {
                    0.0 => "0".to_owned(),
                    value => format!("\"{}\"", number(format!("{name}{at}{k}"), "m", value)),
                });
                names.join(", ")
            };
            let (place_at, centre) = (place("r", link.at), place("c", link.centre));
            if let JointMotion::Screwed(_, lead) = link.ways.first().unwrap_or(&JointMotion::Along(0)) {
                let _ = number(format!("lead{at}"), "m", *lead);
            }
            let to = link.parent.map_or_else(String::new, |to| format!(", to = \"b{to}\""));
            let names = |letter: &str| {
                let list: Vec<String> = (first..first + link.ways.len()).map(|k| format!("\"{letter}{k}\"")).collect();
                list.join(", ")
            };
            let _ = writeln!(
                joints,
                "j{at} = {{ kind = \"{}\", body = \"b{at}\"{to}, at = [{place_at}], centre = [{centre}], coordinates = [{}], speeds = [{}]{} }}",
                link.kind,
                names("q"),
                names("u"),
                link.keys
            );
            if let Some((stiffness, damping)) = link.spring {
                let (k, c) = (number(format!("k{at}"), "1", stiffness), number(format!("d{at}"), "1", damping));
                loads += &link.load(at, first, &k, &c);
            }
            first += link.ways.len();
        }
        format!(
            "name = \"Random tree\"\n[parameters]\n{parameters}oneN = {{ unit = \"N\", value = 1 }}\noneM = {{ unit = \"m\", value = 1 }}\noneS = {{ unit = \"s\", value = 1 }}\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[bodies]\n{bodies}[joints]\n{joints}{loads}[gravity]\nframe = \"N\"\nacceleration = [0, 0, \"-g\"]\n"
        )
    }

    /// Rotation and mass centre of each body, and its joint's relative rotation, for coordinates as polynomials in
    /// time.
    fn poses(&self, q: &[Jet]) -> Vec<(Turn, [Jet; 3], Turn)> {
        let unit: Turn = [0, 1, 2].map(|i| [0, 1, 2].map(|j| Jet::constant(f64::from(u8::from(i == j)))));
        let origin = [Jet::ZERO; 3];
        let (mut homes, mut poses, mut first) = (Vec::new(), Vec::new(), 0);
        for link in &self.links {
            let (base, home) = link.parent.map_or((unit, origin), |to: usize| homes[to]);
            let (mut way, mut turn) = (link.at.map(Jet::constant), unit);
            for (of, q) in link.ways.iter().zip(&q[first..]) {
                match *of {
                    JointMotion::Along(axis) => way[axis] = way[axis] + *q,
                    JointMotion::About(axis) => turn = times(&turn, &about(axis, *q)),
                    JointMotion::Screwed(axis, lead) => {
                        way[axis] = way[axis] + Jet::constant(lead / std::f64::consts::TAU) * *q;
                        turn = times(&turn, &about(axis, *q));
                    }
                }
            }
            first += link.ways.len();
            let whole = times(&base, &turn);
            let offset = turned(&base, way);
            let joint = [0, 1, 2].map(|k| home[k] + offset[k]);
            let arm = turned(&whole, link.centre.map(Jet::constant));
            homes.push((whole, joint));
            poses.push((whole, [0, 1, 2].map(|k| joint[k] + arm[k]), turn));
        }
        poses
    }

    /// q̇ from q and u.
    pub fn rates(&self, q: &[f64], u: &[f64]) -> Vec<f64> {
        let (mut rates, mut first) = (u.to_vec(), 0);
        for link in &self.links {
            let n = link.ways.len();
            if link.is_ball {
                let at = first + n - 3;
                let matrix = Matrix3::from_columns(&[0, 1, 2].map(|k| {
                    let jets: Vec<Jet> =
                        (0..q.len()).map(|i| Jet([q[i], f64::from(u8::from(i == at + k)), 0.0])).collect();
                    self.relative_spin(first, &jets).0
                }));
                let solved = matrix.lu().solve(&Vector3::from_row_slice(&u[at..at + 3])).expect("away from poles");
                rates[at..at + 3].copy_from_slice(solved.as_slice());
            }
            first += n;
        }
        rates
    }

    /// Relative angular velocity of the joint with this first coordinate and its rate, in the frame of its body.
    fn relative_spin(&self, first: usize, q: &[Jet]) -> (Vector3<f64>, Vector3<f64>) {
        let mut before = 0;
        let at = self.links.iter().position(|link| {
            before += link.ways.len();
            before > first
        });
        let turn = self.poses(q)[at.expect("a joint with coordinates")].2;
        let (omega, alpha) = spin(&turn);
        let r = part(&turn, 0).transpose();
        // d/dt (Rᵀ ω) = Rᵀ α, since Rᵀ (ω × ω) = 0.
        (r * omega, r * alpha)
    }

    /// (q̈, u̇) from q and u.
    pub fn accelerations(&self, q: &[f64], u: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = q.len();
        let rates = self.rates(q, u);
        let jets = |rates: &[f64], seconds: &[f64]| -> Vec<Jet> {
            (0..n).map(|i| Jet([q[i], rates[i], seconds[i] / 2.0])).collect()
        };
        let still = vec![0.0; n];
        let now = self.poses(&jets(&rates, &still));
        let along: Vec<_> = (0..n)
            .map(|k| {
                let one: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == k))).collect();
                self.poses(&jets(&one, &still))
            })
            .collect();
        let velocity = |place: &[Jet; 3]| Vector3::from_fn(|k, _| place[k].0[1]);
        let mut matrix = DMatrix::zeros(n, n);
        let mut right = DVector::from_vec(self.forces(q, &rates));
        for (b, link) in self.links.iter().enumerate() {
            let (turn, place, _) = &now[b];
            let (omega, alpha) = spin(turn);
            let r = part(turn, 0);
            let inertia = r * link.inertia * r.transpose();
            let acceleration = Vector3::from_fn(|k, _| 2.0 * place[k].0[2]) + Vector3::new(0.0, 0.0, GRAVITY);
            let force = link.mass * acceleration;
            let torque = inertia * alpha + omega.cross(&(inertia * omega));
            let partial: Vec<_> = along.iter().map(|poses| (velocity(&poses[b].1), spin(&poses[b].0).0)).collect();
            for (i, (v_i, w_i)) in partial.iter().enumerate() {
                right[i] -= v_i.dot(&force) + w_i.dot(&torque);
                for (j, (v_j, w_j)) in partial.iter().enumerate() {
                    matrix[(i, j)] += link.mass * v_i.dot(v_j) + w_i.dot(&(inertia * w_j));
                }
            }
        }
        let seconds: Vec<f64> = matrix.lu().solve(&right).expect("regular").as_slice().to_vec();
        let mut u_dot = seconds.clone();
        let mut first = 0;
        for link in &self.links {
            if link.is_ball {
                let at = first + link.ways.len() - 3;
                let rate = self.relative_spin(first, &jets(&rates, &seconds)).1;
                u_dot[at..at + 3].copy_from_slice(rate.as_slice());
            }
            first += link.ways.len();
        }
        (seconds, u_dot)
    }

    /// Generalized forces of springs and dampers along q̇.
    fn forces(&self, q: &[f64], rates: &[f64]) -> Vec<f64> {
        let (mut forces, mut first) = (vec![0.0; q.len()], 0);
        for link in &self.links {
            if let Some((stiffness, damping)) = link.spring {
                forces[first] = -stiffness * q[first] - damping * rates[first];
            }
            first += link.ways.len();
        }
        forces
    }

    /// q and u after a time, by the classical Runge–Kutta method in so many steps.
    pub fn after(&self, q: &[f64], u: &[f64], time: f64, steps: u32) -> (Vec<f64>, Vec<f64>) {
        let h = time / f64::from(steps);
        let n = q.len();
        let mut x = [q, u].concat();
        let slope = |x: &[f64]| [self.rates(&x[..n], &x[n..]), self.accelerations(&x[..n], &x[n..]).1].concat();
        let moved = |x: &[f64], k: &[f64], h: f64| -> Vec<f64> { x.iter().zip(k).map(|(x, k)| x + h * k).collect() };
        for _ in 0..steps {
            let k1 = slope(&x);
            let k2 = slope(&moved(&x, &k1, h / 2.0));
            let k3 = slope(&moved(&x, &k2, h / 2.0));
            let k4 = slope(&moved(&x, &k3, h));
            for i in 0..2 * n {
                x[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            }
        }
        let u = x.split_off(n);
        (x, u)
    }
}

impl Link {
    fn new(random: &mut Random, at: usize) -> Self {
        let parent = (at > 0 && random.chance(85)).then(|| if random.chance(70) { at - 1 } else { random.below(at) });
        let axis = random.below(3);
        let kind = *random.one(&["pin", "slider", "cylinder", "screw", "universal", "ball", "planar", "free", "weld"]);
        // What is welded to the ground moves nothing.
        let kind = if kind == "weld" && parent.is_none() { "ball" } else { kind };
        let sequence = *random.one(&["123", "213", "321", "313", "323", "231", "121"]);
        let turns: Vec<JointMotion> =
            sequence.bytes().map(|digit| JointMotion::About(usize::from(digit - b'1'))).collect();
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let lead = random.decimal(0.1, 0.6);
        let about_axis = format!(", axis = {}", axis + 1);
        let (ways, keys) = match kind {
            "pin" => (vec![JointMotion::About(axis)], about_axis),
            "slider" => (vec![JointMotion::Along(axis)], about_axis),
            "cylinder" => (vec![JointMotion::About(axis), JointMotion::Along(axis)], about_axis),
            "screw" => (vec![JointMotion::Screwed(axis, lead)], format!("{about_axis}, lead = \"lead{at}\"")),
            "universal" => {
                (vec![JointMotion::About(axis), JointMotion::About(j)], format!(", axes = [{}, {}]", axis + 1, j + 1))
            }
            "planar" => (vec![JointMotion::Along(j), JointMotion::Along(k), JointMotion::About(axis)], about_axis),
            "ball" => (turns, format!(", sequence = \"{sequence}\"")),
            "free" => {
                let ways = [0, 1, 2].map(JointMotion::Along).into_iter().chain(turns).collect();
                (ways, format!(", sequence = \"{sequence}\""))
            }
            _ => (Vec::new(), String::new()),
        };
        let mut place =
            |percent: usize| [0, 1, 2].map(|_| if random.chance(percent) { 0.0 } else { random.decimal(-0.5, 0.5) });
        let (at, centre) = (place(40), place(50));
        // Principal moments that a body can have, and small products.
        let mut inertia = Matrix3::from_diagonal(&Vector3::from_fn(|_, _| random.decimal(0.5, 0.9)));
        let is_skew = random.chance(50);
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let product = if is_skew { random.decimal(-0.05, 0.05) } else { 0.0 };
            (inertia[(i, j)], inertia[(j, i)]) = (product, product);
        }
        let has_spring = ["pin", "slider"].contains(&kind) && random.chance(50);
        let spring = has_spring.then(|| (random.decimal(1.0, 5.0), random.decimal(0.1, 1.0)));
        let is_ball = ["ball", "free"].contains(&kind);
        Self { kind, keys, ways, is_ball, parent, at, centre, mass: random.decimal(0.5, 3.0), inertia, spring }
    }

    /// A spring and a damper along the joint's one coordinate, as the model file states them.
    fn load(&self, at: usize, first: usize, k: &str, c: &str) -> String {
        let against = self.parent.map_or_else(String::new, |to| format!("against = \"b{to}\"\n"));
        let frame = self.parent.map_or_else(|| "N".to_owned(), |to| format!("b{to}_frame"));
        let (section, place, law, axis) = match self.ways[0] {
            JointMotion::About(axis) | JointMotion::Screwed(axis, _) => {
                ("torques", String::new(), format!("-({k}*q{first} + {c}*oneS*q{first}')*oneN*oneM"), axis)
            }
            JointMotion::Along(axis) => {
                ("forces", format!("at = \"j{at}\"\n"), format!("-({k}*q{first} + {c}*oneS*q{first}')*oneN/oneM"), axis)
            }
        };
        let vector = [0, 1, 2].map(|i| if i == axis { format!("\"{law}\"") } else { "0".to_owned() }).join(", ");
        format!("[{section}.s{at}]\non = \"b{at}\"\n{place}{against}frame = \"{frame}\"\nvector = [{vector}]\n")
    }
}
