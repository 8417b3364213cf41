//! Runs by equations in moving frames, against closed forms and against full equations.

use proptest::prelude::*;
use std::fmt::Write;
use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::diagnostic::Source;

fn scene(model: &str, scene: &str) -> Scene {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    Scene::parse(Mechanism::new(model), scene).unwrap_or_else(|e| panic!("{e}"))
}

fn column(scene: &Scene, by: Option<&str>, name: &str) -> Vec<f64> {
    let run = scene.simulate(&Overrides { by: by.map(Into::into), ..Overrides::default() }).unwrap();
    assert!(run.failure().is_none(), "{by:?}: {:?}", run.objections());
    run.column_of_quantity(name).unwrap()
}

/// Two masses that attract one another. The law is a potential of their distance d and two parameters.
fn two_bodies(law: &str) -> String {
    let names = ["x", "y", "z", "X", "Y", "Z"];
    let coordinates: String = names.map(|q| format!("{q} = {{ unit = \"m\" }}\n")).concat();
    let speeds: String = names.map(|q| format!("v{q} = \"{q}'\"\n")).concat();
    let law = law.replace('d', "distance(A, B)");
    format!(
        r#"
name = "Two bodies"
[parameters]
m = {{ unit = "kg", value = 1.5, positive = true }}
M = {{ unit = "kg", value = 4.25, positive = true }}
k = {{ unit = "N*m^2", value = 2.3, positive = true }}
s = {{ unit = "N/m", value = 0.7, positive = true }}
l = {{ unit = "m", value = 0.9, positive = true }}
[coordinates]
{coordinates}
[speeds]
{speeds}
[inertial]
frame = "N"
origin = "O"
[points]
A = {{ from = "O", frame = "N", position = ["x", "y", "z"] }}
B = {{ from = "O", frame = "N", position = ["X", "Y", "Z"] }}
[particles]
a = {{ point = "A", mass = "m" }}
b = {{ point = "B", mass = "M" }}
[potentials]
between = "{law}"
"#
    )
}

/// A start of relative place and velocity, with a drift of the whole.
fn start(place: [f64; 3], velocity: [f64; 3]) -> String {
    let mut lines = String::new();
    for (at, (small, large)) in [("x", "X"), ("y", "Y"), ("z", "Z")].into_iter().enumerate() {
        let (drift, corner) = (0.3 - 0.2 * at as f64, 1.0 - 0.7 * at as f64);
        let _ = writeln!(lines, "{small} = {corner:?}\n{large} = {:?}", corner + place[at]);
        let _ = writeln!(lines, "v{small} = {drift:?}\nv{large} = {:?}", drift + velocity[at]);
    }
    lines
}

const INTEGRATION: &str = "[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-14\nsamples = 41\n";

/// Kepler's ellipse: r = a (1 − e cos E) with n t = E − e sin E, from the pericentre at distance 0.8.
#[test]
fn two_bodies_move_on_keplers_ellipse() {
    let (m, big, k) = (1.5, 4.25, 2.3);
    let (near, e) = (0.8, 0.6);
    let a: f64 = near / (1.0 - e);
    let strength: f64 = k * (m + big) / (m * big);
    let fastest = (strength * (1.0 + e) / near).sqrt();
    // Any plane will do: the velocity is perpendicular to the place, along no axis.
    let (place, velocity) = ([0.48, 0.64, 0.0], [-0.48 * fastest, 0.36 * fastest, 0.8 * fastest]);
    let text = format!(
        "outputs = [{{ name = \"d\", value = \"distance(A, B)\" }}]\nspan = [0, 8]\n[start]\n{}{INTEGRATION}",
        start(place, velocity)
    );
    let scene = scene(&two_bodies("-k/d"), &text);
    let reduced = scene.reduce().unwrap().reduction;
    assert_eq!((reduced.states.len(), reduced.quadratures.len()), (2, 0));
    let mean = (strength / a.powi(3)).sqrt();
    for (at, d) in column(&scene, Some("reduced"), "d").into_iter().enumerate() {
        let anomaly = mean * 8.0 * at as f64 / 40.0;
        let eccentric = (0..60).fold(anomaly, |x: f64, _| x - (x - e * x.sin() - anomaly) / (1.0 - e * x.cos()));
        let exact = a * (1.0 - e * eccentric.cos());
        assert!((d - exact).abs() < 1e-9, "{at}: {d} for {exact}");
    }
}

/// Goal: a start at which the frame is singular is moved away first.
#[test]
fn a_start_across_the_section_is_turned() {
    for place in [[0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]] {
        let text = format!(
            "outputs = [{{ name = \"d\", value = \"distance(A, B)\" }}]\nspan = [0, 1]\n[start]\n{}{INTEGRATION}",
            start(place, [0.3, -0.4, 0.5])
        );
        let scene = scene(&two_bodies("s*d^2/2 - k/d"), &text);
        assert!(scene.reduce().unwrap().reduction.frame.is_some());
        let (own, whole) = (column(&scene, Some("reduced"), "d"), column(&scene, Some("kane"), "d"));
        assert!(own.iter().zip(&whole).all(|(a, b)| (a - b).abs() < 1e-9), "{place:?}");
    }
}

/// Goal: a frame is used without conserved momenta. Drag destroys the momenta, and yet all directions are equivalent:
/// the frame takes one of four states. Truth: damped oscillations along both axes are the closed form.
#[test]
fn a_frame_needs_no_momentum() {
    let model = r#"
name = "Damped planar oscillator"
[parameters]
m = { unit = "kg", value = 1.5, positive = true }
k = { unit = "N/m", value = 2.3, positive = true }
c = { unit = "N*s/m", value = 0.3, positive = true }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
[speeds]
vx = "x'"
vy = "y'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", "y", 0] }
[particles]
bob = { point = "P", mass = "m" }
[forces.pull]
on = "bob"
frame = "N"
vector = ["-k*x - c*vx", "-k*y - c*vy", 0]
"#;
    let text = format!(
        "outputs = [{{ name = \"r\", value = \"sqrt(x^2 + y^2)\" }}]\nspan = [0, 6]\n[start]\nx = 1\ny = 0.5\nvx = -0.2\nvy = 0.9\n{INTEGRATION}"
    );
    let scene = scene(model, &text);
    let reduction = scene.reduce().unwrap().reduction;
    assert_eq!((reduction.states.len(), reduction.constants.len()), (3, 0));
    let (m, k, c) = (1.5_f64, 2.3, 0.3);
    let fading = c / (2.0 * m);
    let rate = (k / m - fading * fading).sqrt();
    let along = |t: f64, x: f64, v: f64| {
        (-fading * t).exp() * (x * (rate * t).cos() + (v + fading * x) / rate * (rate * t).sin())
    };
    for (at, r) in column(&scene, Some("reduced"), "r").into_iter().enumerate() {
        let t = 6.0 * at as f64 / 40.0;
        let exact = along(t, 1.0, -0.2).hypot(along(t, 0.5, 0.9));
        assert!((r - exact).abs() < 1e-9, "{at}: {r} for {exact}");
    }
}

/// Outputs that rotations and translations leave unchanged, except the fifth.
const INVARIANTS: [&str; 6] = [
    "distance(A, B)",
    "(X - x)*(vX - vx) + (Y - y)*(vY - vy) + (Z - z)*(vZ - vz)",
    "(vX - vx)^2 + (vY - vy)^2 + (vZ - vz)^2",
    "total_energy",
    "vx + vy*0.5",
    "(X - x)*vX' + (Y - y)*vY' + (Z - z)*vZ'",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Goal: the states that a frame leaves out change no number. Method: random starts, laws and outputs,
    /// accelerations and energies among them; Kane's full equations to a tenth of the tolerance.
    #[test]
    fn random_motions_are_those_of_the_whole(
        place in prop::array::uniform3(-1.0..1.0_f64),
        velocity in prop::array::uniform3(-1.0..1.0_f64),
        law in prop::sample::select(vec!["-k/d", "s*d^2/2", "s*(d - l)^2/2", "s*d^2/2 - k/d"]),
        asked in prop::sample::subsequence((0..INVARIANTS.len()).collect::<Vec<_>>(), 1..4),
    ) {
        prop_assume!(place.iter().map(|x| x * x).sum::<f64>() > 0.3);
        let cross = |i: usize, j: usize| place[i] * velocity[j] - place[j] * velocity[i];
        prop_assume!(cross(0, 1).hypot(cross(1, 2)).hypot(cross(2, 0)) > 0.3);
        let outputs: Vec<String> = asked
            .iter()
            .map(|at| format!("{{ name = \"o{at}\", value = \"{}\" }}", INVARIANTS[*at]))
            .collect();
        let text = format!(
            "outputs = [{}]\nspan = [0, 2]\n[start]\n{}{INTEGRATION}",
            outputs.join(", "),
            start(place, velocity)
        );
        let scene = scene(&two_bodies(law), &text);
        let framed = scene.reduce().unwrap().reduction.frame.is_some();
        // Rotations change vx.
        prop_assert!(framed || asked.contains(&4));
        for at in &asked {
            let name = format!("o{at}");
            let (own, whole) = (column(&scene, Some("reduced"), &name), column(&scene, Some("kane"), &name));
            for (a, b) in own.iter().zip(&whole) {
                prop_assert!((a - b).abs() < 1e-8 * (1.0 + b.abs()), "{name} of {law}: {a} for {b}");
            }
        }
    }
}
