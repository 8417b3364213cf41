//! Motions of mechanisms that nothing holds: growth like a power of t, and families of steady motions.

use crate::random_trees::times;
use crate::spectra::{Random, grown, mixed};
use nalgebra::DMatrix;
use std::fmt::Write;
use tripos::Mechanism;
use tripos::studies::steady::{LinearisationOptions, Stability, SteadyLinearSystem, WideMatrix, linearise};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::load_state_with_unknowns;
use tripos_traits::{DoubleDouble, Scalar};
fn about(model: &str, state: &str, whole: bool) -> SteadyLinearSystem {
    let source = Source::from_text("model.toml", model);
    let mut model = Mechanism::new(tripos_derive::model::load(&source).unwrap_or_else(|e| panic!("{e}\n{model}")));
    let state = load_state_with_unknowns(&Source::from_text("state.toml", state), &mut model, &[])
        .unwrap_or_else(|e| panic!("{e}"));
    linearise(&model, &state, &LinearisationOptions { whole, ..LinearisationOptions::default() })
        .unwrap_or_else(|e| panic!("{e}"))
}

const PLATE: &str = r#"
name = "Plate held up by a thrust through its middle"
[parameters]
m = { unit = "kg", value = 2 }
J = { unit = "kg*m^2", value = 0.1 }
F = { unit = "N", value = 20 }
g = "10 m/s^2"
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
th = { unit = "rad" }
[speeds]
vx = "x'"
vy = "y'"
w = "th'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "th" }
[points]
G = { from = "O", frame = "N", position = ["x", "y", 0] }
[bodies.plate]
frame = "B"
centre = "G"
mass = "m"
inertia = "J"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[forces.thrust]
on = "plate"
frame = "B"
vector = [0, "F", 0]
"#;

/// Goal: growth like a power of t is not called stable. Method: a plate that hovers, vx = −5 w t²; with its place kept,
/// x = −5 w t³/3.
#[test]
fn a_plate_that_hovers_grows_like_a_power() {
    let state = "[state]\nx = 0\ny = 0\nth = 0\nvx = 0\nvy = 0\nw = 0\n";
    for (whole, power) in [(false, 2), (true, 3)] {
        let found = about(PLATE, state, whole);
        assert_eq!(found.stability, Stability::Grows(power));
        assert!(
            found.stability.stability_sentence().contains(&format!("grows like t^{power}")),
            "{}",
            found.stability.stability_sentence()
        );
        assert!(found.modes.iter().all(|mode| mode.value == [0.0, 0.0]), "{:?}", found.modes);
    }
}

/// Particles on a line, whose places are whole combinations of the coordinates, with springs between some of them and
/// to the ground.
struct Carts {
    mass: Vec<f64>,
    /// Springs: the first particle, the second or `None` for the ground, and the stiffness.
    springs: Vec<(usize, Option<usize>, f64)>,
    mixing: DMatrix<i64>,
}

impl Carts {
    fn new(random: &mut Random) -> Self {
        let n = 2 + usize::try_from(random.below(3)).unwrap();
        let part = |random: &mut Random| 0.5 + random.below(8) as f64 / 4.0;
        let mass: Vec<f64> = (0..n).map(|_| part(random)).collect();
        let mut springs = Vec::new();
        for i in 0..n {
            let stiff = part(random) * 10.0;
            match random.below(4) {
                0 if i > 0 => springs.push((i, Some(i - 1), stiff)),
                1 => springs.push((i, None, stiff)),
                2 if i > 0 => springs.push((i, Some(0), stiff)),
                _ => {}
            }
        }
        let mixing = mixed(random, DMatrix::identity(n, n));
        Self { mass, springs, mixing }
    }

    fn place(&self, i: usize) -> String {
        let terms = self.mixing.row(i).iter().enumerate().map(|(j, k)| format!("({k})*q{j}")).collect::<Vec<_>>();
        terms.join(" + ")
    }

    fn text(&self) -> String {
        let n = self.mass.len();
        let mut out = "name = \"Carts\"\n[parameters]\n".to_owned();
        for (i, m) in self.mass.iter().enumerate() {
            let _ = writeln!(out, "m{i} = {{ unit = \"kg\", value = {m:?}, positive = true }}");
        }
        for (at, (_, _, k)) in self.springs.iter().enumerate() {
            let _ = writeln!(out, "k{at} = {{ unit = \"N/m\", value = {k:?}, positive = true }}");
        }
        out += "[coordinates]\n";
        for i in 0..n {
            let _ = writeln!(out, "q{i} = {{ unit = \"m\" }}");
        }
        out += "[speeds]\n";
        for i in 0..n {
            let _ = writeln!(out, "u{i} = \"q{i}'\"");
        }
        out += "[inertial]\nframe = \"N\"\norigin = \"O\"\n[points]\n";
        for i in 0..n {
            let _ = writeln!(out, "P{i} = {{ from = \"O\", frame = \"N\", position = [\"{}\", 0, 0] }}", self.place(i));
        }
        out += "[particles]\n";
        for i in 0..n {
            let _ = writeln!(out, "p{i} = {{ point = \"P{i}\", mass = \"m{i}\" }}");
        }
        out += "[potentials]\n";
        for (at, (i, other, _)) in self.springs.iter().enumerate() {
            let other = other.map_or_else(String::new, |j| format!(" - ({})", self.place(j)));
            let _ = writeln!(out, "s{at} = \"k{at}/2*({}{other})^2\"", self.place(*i));
        }
        if self.springs.is_empty() { out.replace("[potentials]\n", "") } else { out }
    }

    /// Matrix A of x' = A x for all places and velocities, by hand.
    fn matrix(&self) -> DMatrix<f64> {
        let n = self.mass.len();
        let mut a = DMatrix::zeros(2 * n, 2 * n);
        (0..n).for_each(|i| a[(i, n + i)] = 1.0);
        for (i, other, k) in &self.springs {
            a[(n + i, *i)] -= k / self.mass[*i];
            if let Some(j) = other {
                a[(n + i, *j)] += k / self.mass[*i];
                a[(n + j, *i)] += k / self.mass[*j];
                a[(n + j, *j)] -= k / self.mass[*j];
            }
        }
        a
    }
}

/// Goal: free parts of a mechanism grow like t if their places are kept; a mechanism whose parts are all held is at a
/// minimum of the energy. Method: carts with random springs, in mixed coordinates, against the exponential of the
/// matrix written down by hand.
#[test]
fn carts_that_nothing_holds_grow_like_t() {
    let mut random = Random(77);
    let (mut floating, mut held) = (0, 0);
    for turn in 0..16 * times() {
        let carts = Carts::new(&mut random);
        let n = carts.mass.len();
        let names = (0..n).map(|i| format!("q{i} = 0\nu{i} = 0\n")).collect::<Vec<_>>().concat();
        let found = about(&carts.text(), &format!("[state]\n{names}"), true);
        let by_hand = carts.matrix();
        let rows = by_hand.row_iter().map(|row| row.iter().map(|x| DoubleDouble::from_f64(*x)).collect());
        let truth = grown(&WideMatrix { rows: rows.collect() });
        let told = found.stability;
        let what = format!("turn {turn}: t^{truth}, {told:?}\n{}", carts.text());
        if truth > 0.5 {
            assert_eq!(told, Stability::Grows(1), "{what}");
            assert!(!told.name().contains("stable") && !told.stability_sentence().contains("stable"), "{what}");
            floating += 1;
        } else {
            assert_eq!(told, Stability::Energy, "{what}");
            held += 1;
        }
        let zeros = found.modes.iter().filter(|mode| mode.value == [0.0, 0.0]).count();
        // There are two zeros for each direction that no spring resists.
        let of_hand = 2 * (n - by_hand.view((n, 0), (n, n)).rank(1e-9));
        assert_eq!(zeros, of_hand, "{what}");
    }
    assert!(floating > 4 && held > 2, "{floating} {held}");
}

/// Goal: a Jordan block on the imaginary axis away from 0 is found. Method: a free particle in a frame that turns at w
/// keeps ±w i, twice, with a block each. Held by a spring k = m w² in that frame it has 0 twice and ±2 w i, as
/// Foucault's pendulum without its weight.
#[test]
fn a_free_particle_in_a_turning_frame_grows_like_t() {
    let text = |k: &str| {
        format!(
            r#"
name = "Particle in a turning frame"
[parameters]
m = {{ unit = "kg", value = 0.7, positive = true }}
w = "3 rad/s"
k = "{k} N/m"
[coordinates]
x = {{ unit = "m" }}
y = {{ unit = "m" }}
[speeds]
u = "x'"
v = "y'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = {{ from = "N", axis = 3, angle = "w*t" }}
[points]
P = {{ from = "O", frame = "A", position = ["x", "y", 0] }}
[particles]
p = {{ point = "P", mass = "m" }}
[forces.spring]
on = "p"
frame = "A"
vector = ["-k*x", "-k*y", 0]
"#
        )
    };
    let state = "[state]\nx = 0\ny = 0\nu = 0\nv = 0\n";
    let free = about(&text("0"), state, true);
    assert_eq!(free.stability, Stability::Grows(1), "{:?}", free.modes);
    assert!(free.modes.iter().all(|m| m.is_neutral() && (m.value[1].abs() - 3.0).abs() < 1e-15 && m.multiplicity == 2));
    // x'' − 2 w y' + (k/m − w²) x = 0: s = ±i (w ± sqrt(k/m)).
    let held = about(&text("10"), state, true);
    let root = f64::sqrt(10.0 / 0.7);
    for wanted in [3.0 + root, root - 3.0] {
        assert!(held.modes.iter().any(|m| (m.value[1] - wanted).abs() < 1e-14 && m.is_neutral()), "{:?}", held.modes);
    }
    assert_eq!(held.stability, Stability::FirstOrder);
}

/// Block on which a damper and a force of the place act: u' = −c u + force.
fn damped(force: &str) -> String {
    format!(
        r#"
name = "Damped block"
[parameters]
m = {{ unit = "kg", value = 1, positive = true }}
c = "2 N*s/m"
k = "3 N/m^3"
[coordinates]
q = {{ unit = "m" }}
[speeds]
u = "q'"
[inertial]
frame = "N"
origin = "O"
[points]
P = {{ from = "O", frame = "N", position = ["q", 0, 0] }}
[particles]
p = {{ point = "P", mass = "m" }}
[forces.f]
on = "p"
frame = "N"
vector = ["-c*u + {force}", 0, 0]
"#
    )
}

/// Goal: a family of motions is claimed only where there is one. Method: u' = −2 u ± 3 q³ has the eigenvalues 0 and −2
/// at q = 0, where it is stable for the lower sign alone, so to first order stability is open. Without the cube, with
/// shifted coordinates kept, there is rest at every q.
#[test]
fn a_family_is_claimed_where_there_is_one() {
    for force in ["k*q^3", "-k*q^3"] {
        let found = about(&damped(force), "[state]\nq = 0\nu = 0\n", true);
        assert_eq!((found.stability, found.family.len()), (Stability::FirstOrder, 0), "{force}");
    }
    let found = about(&damped("0*k"), "[state]\nq = 0\nu = 0\n", true);
    assert_eq!((found.stability, found.family), (Stability::AttractingInFamily, vec!["q".to_owned()]));
}
