//! Reactions in loops whose equations are solved for coordinates, so that these leave the model.

use crate::newton::Chance;
use crate::random_trees::times;
use nalgebra::{DMatrix, DVector};
use std::fmt::Write;
use tripos::{Error, Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;

fn run(model: &str, scene: &str) -> Result<Run, Error> {
    let mechanism = tripos_derive::model::load(&Source::from_text("model.toml", model));
    let mechanism = mechanism.unwrap_or_else(|error| panic!("{error}\n{model}"));
    Scene::parse(Mechanism::new(mechanism), scene)?.simulate(&Overrides::default())
}

/// Chain of bodies on sliders from the ground, each along an axis 0, 1 or 2. A further joint holds the last body
/// against the ground along some axes.
struct Chain {
    axes: Vec<usize>,
    masses: Vec<f64>,
    /// Load on each body, N.
    loads: Vec<[f64; 3]>,
    /// Mass centre of each body from its slider, m.
    centres: Vec<[f64; 3]>,
    closing: String,
    is_held: [bool; 3],
}

impl Chain {
    fn new(chance: &mut Chance) -> Self {
        let count = 2 + chance.below(3);
        let axis = chance.below(3);
        let along = |held: bool| std::array::from_fn(|at| (at == axis) == held);
        let (closing, is_held) = match chance.below(4) {
            0 => (format!("kind = \"planar\"\naxis = {}", axis + 1), along(true)),
            1 => (format!("kind = \"slider\"\naxis = {}", axis + 1), along(false)),
            2 => (format!("kind = \"cylinder\"\naxis = {}", axis + 1), along(false)),
            _ => ("kind = \"ball\"".to_owned(), [true; 3]),
        };
        Self {
            axes: (0..count).map(|_| chance.below(3)).collect(),
            masses: (0..count).map(|_| 0.5 + chance.below(30) as f64 / 10.0).collect(),
            loads: (0..count).map(|_| [0; 3].map(|_| chance.number())).collect(),
            centres: (0..count).map(|_| [0; 3].map(|_| chance.number())).collect(),
            closing,
            is_held,
        }
    }

    fn sliders(&self, axis: usize) -> Vec<usize> {
        (0..self.axes.len()).filter(|at| self.axes[*at] == axis).collect()
    }

    fn freedoms(&self) -> usize {
        let free = |axis: usize| self.sliders(axis).len().saturating_sub(usize::from(self.is_held[axis]));
        (0..3).map(free).sum()
    }

    fn model(&self) -> String {
        let mut text = "name = \"chain\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\nF = \"1 N\"\nJ = \"1 kg*m^2\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n".to_owned();
        for (at, mass) in self.masses.iter().enumerate() {
            writeln!(
                text,
                "[bodies.b{at}]\nmass = \"{mass}*m\"\ninertia = {{ diagonal = [\"J\", \"J\", \"J\"] }}\n[joints.J{at}]\nkind = \"slider\"\nbody = \"b{at}\"\naxis = \
                 {}\ncentre = {:?}\n{}[forces.F{at}]\non = \"b{at}\"\nframe = \"N\"\nvector = {:?}",
                self.axes[at] + 1,
                self.centres[at].map(|x| format!("{x}*l")),
                if at > 0 { format!("to = \"b{}\"\n", at - 1) } else { String::new() },
                self.loads[at].map(|x| format!("{x}*F"))
            )
            .unwrap();
        }
        let last = self.axes.len() - 1;
        write!(text, "[joints.closing]\n{}\nbody = \"b{last}\"\n", self.closing).unwrap();
        text
    }

    /// A start in which the loop is closed: the last slider along each held axis follows from the others.
    fn scene(&self, outputs: &[String]) -> String {
        let names = outputs.iter().map(|name| format!("{name:?}")).collect::<Vec<_>>().join(", ");
        let mut text = format!("span = [0, 0.01]\noutputs = [{names}]\n[start]\n");
        for (at, axis) in self.axes.iter().enumerate() {
            if !self.is_held[*axis] || self.sliders(*axis).last() != Some(&at) {
                writeln!(text, "q_J{at} = {}\n\"q_J{at}'\" = {}", 0.1 * (at + 1) as f64, 0.2).unwrap();
            }
        }
        text
    }

    /// Forces of the sliders and of the closing joint along an axis, by Newton's law for each body. A slider carries no
    /// force along its own axis, and otherwise lets no body move along the axis. `None` if these laws do not determine
    /// the forces.
    fn forces(&self, axis: usize) -> Option<Vec<f64>> {
        let count = self.axes.len();
        let mut matrix = DMatrix::<f64>::zeros(2 * count + 1, 2 * count + 1);
        let mut right = DVector::<f64>::zeros(2 * count + 1);
        for at in 0..count {
            // m a − F + F of the next slider = load.
            matrix[(at, at)] = self.masses[at];
            matrix[(at, count + at)] = -1.0;
            right[at] = self.loads[at][axis];
            // The closing joint follows the last slider, and acts on the last body.
            matrix[(at, count + at + 1)] = if at + 1 < count { 1.0 } else { -1.0 };
            if self.axes[at] == axis {
                matrix[(count + at, count + at)] = 1.0;
            } else {
                matrix[(count + at, at)] = 1.0;
                if at > 0 {
                    matrix[(count + at, at - 1)] = -1.0;
                }
            }
        }
        matrix[(2 * count, if self.is_held[axis] { count - 1 } else { 2 * count })] = 1.0;
        let factors = matrix.lu();
        (factors.determinant().abs() > 1e-9).then(|| factors.solve(&right).unwrap().as_slice()[count..].to_vec())
    }

    /// Names of the forces of [`Self::forces`].
    fn names(&self, axis: usize) -> Vec<String> {
        let count = self.axes.len();
        let below = |at: usize| if at > 0 { format!("b{}", at - 1) } else { "ground".to_owned() };
        let mut names: Vec<String> =
            (0..count).map(|at| format!("force({} on b{at}) @ N [{}]", below(at), axis + 1)).collect();
        names.push(format!("force(ground on b{}) @ N [{}]", count - 1, axis + 1));
        names
    }
}

/// Goal: joints carry no force along ways that they leave open, even where an equation of a loop fixed their
/// coordinate, and forces that statics does not determine are refused. Method: random chains of sliders, closed by a
/// joint to the ground. Newton's law for each body and each axis gives the forces.
#[test]
fn sliders_in_closed_chains_carry_nothing_along_themselves() {
    let mut chance = Chance(5);
    let (mut asked, mut refused) = (0, 0);
    for case in 0..40 * times() {
        let chain = Chain::new(&mut chance);
        if chain.freedoms() == 0 {
            continue;
        }
        let model = chain.model();
        for axis in 0..3 {
            let names = chain.names(axis);
            match (chain.forces(axis), run(&model, &chain.scene(&names))) {
                (Some(forces), Ok(run)) => {
                    for (name, force) in names.iter().zip(&forces) {
                        let found = *run.column_of_quantity(name).unwrap().last().unwrap();
                        asked += 1;
                        assert!((found - force).abs() < 1e-9, "case {case}: {name} is {found}, not {force}\n{model}");
                    }
                }
                (None, Err(error)) => {
                    refused += 1;
                    assert!(error.to_string().contains("does not determine"), "case {case}: {error}\n{model}");
                }
                (Some(_), Err(error)) => panic!("case {case}: {error}\n{model}"),
                (None, Ok(_)) => panic!("case {case}: axis {axis} was answered\n{model}"),
            }
        }
    }
    assert!(asked > 100 && refused > 5, "{asked}, {refused}");
}

/// Goal: of the speeds of joints, those along coordinates that a loop fixes come last. Method: a Scotch yoke goes
/// through the poses in which its yoke stands still, by each formulation. Truth: T is constant, and gives the rate of
/// the angle.
#[test]
fn a_scotch_yoke_runs_through_its_dead_points_by_every_formulation() {
    let model = r#"
name = "Scotch yoke"
[parameters]
m = "1 kg"
J = "1 kg*m^2"
r = "0.3 m"
[inertial]
frame = "N"
origin = "O"
[bodies]
yoke = { mass = "m", inertia = "J" }
block = { mass = "m", inertia = "J" }
crank = { mass = "m", inertia = "J" }
[joints]
guide = { kind = "slider", body = "yoke", axis = 1, coordinates = ["x"] }
slot = { kind = "slider", body = "block", to = "yoke", axis = 2, coordinates = ["y"] }
eye = { kind = "pin", body = "crank", to = "block", axis = 3, coordinates = ["q"] }
shaft = { kind = "pin", body = "crank", axis = 3, body_at = ["r", 0, 0] }
"#;
    // 2 T/q'² of the crank about the shaft, the block and the yoke.
    let inertia = |q: f64| 1.0 + 0.09 * (2.0 + q.sin().powi(2));
    let rate = |q: f64| 2.0 * (inertia(0.5) / inertia(q)).sqrt();
    let mut q = 0.5;
    let (count, span) = (4000, 2.0);
    for _ in 0..count {
        let h = span / f64::from(count);
        let k1 = rate(q);
        let k2 = rate(q + h * k1 / 2.0);
        let k3 = rate(q + h * k2 / 2.0);
        let k4 = rate(q + h * k3);
        q += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
    }
    let scene = "span = [0, 2]\noutputs = [\"q\"]\n[start]\nq = 0.5\n\"q'\" = 2\n[integration]\nrtol = 1e-11\natol = 1e-12\nmethod = \"dop853\"\n";
    let mechanism = tripos_derive::model::load(&Source::from_text("model.toml", model)).unwrap();
    let scene = Scene::parse(Mechanism::new(mechanism), scene).unwrap();
    for by in ["kane", "lagrange", "newton-euler"] {
        let run = scene.simulate(&Overrides { by: Some(by.into()), ..Overrides::default() }).unwrap();
        let found = *run.column_of_quantity("q").unwrap().last().unwrap();
        assert!(run.failure().is_none() && (found - q).abs() < 1e-9, "{by}: {found}, not {q}");
    }
}

/// Goal: a joint carries nothing along a way that it leaves open, where bodies turn as well. Method: a slider and a
/// planar joint, closed by a ball; all turn about vertical axes, so that the weights pass the joints by. The ball alone
/// carries both along the slider's axis.
#[test]
fn a_planar_joint_hands_no_weight_to_its_slider() {
    let model = r#"
name = "A slider along an oblique rail, a planar joint on it, a ball that holds it to the ground"
[parameters]
m = "1 kg"
J = "1 kg*m^2"
g = "10 m/s^2"
e = "0.2 m"
[inertial]
frame = "N"
origin = "O"
[bodies]
a = { mass = "m", inertia = { diagonal = ["J", "J", "J"] } }
b = { mass = "m", inertia = { diagonal = ["J", "J", "J"] } }
[joints]
guide = { kind = "slider", body = "a", axis = 3, coordinates = ["z"] }
arm = { kind = "planar", body = "b", to = "a", axis = 3, coordinates = ["x", "y", "th"] }
hold = { kind = "ball", body = "b", body_at = ["e", 0, 0] }
[gravity]
frame = "N"
acceleration = ["g", 0, "-g"]
[forces.side]
on = "b"
frame = "N"
vector = [0, "m*g", 0]
"#;
    let moved = model
        .replace("axis = 3, coordinates = [\"z\"] }", "axis = 3, coordinates = [\"z\"], centre = [\"e\", \"e\", 0] }");
    assert_ne!(moved, model);
    for model in [model, &moved] {
        let scene = "span = [0, 0.3]\noutputs = [\"hold_force3\", \"force(ground on a) @ N [1]\"]\n[start]\nth = 1\n\"th'\" = 2\n";
        let run = run(model, scene).unwrap_or_else(|error| panic!("{error}"));
        let end = |name: &str| *run.column_of_quantity(name).unwrap().last().unwrap();
        assert!((end("hold_force3") - 20.0).abs() < 1e-9, "{}", end("hold_force3"));
        assert!((end("force(ground on a) @ N [1]") + 10.0).abs() < 1e-9);
    }
}
