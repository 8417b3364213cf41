//! Equilibria and linear systems of mechanisms with turning drives, with inputs that are formulas, and at poles.
//!
//! Truth: closed forms, and equations of motion written down here.

use tripos::Mechanism;
use tripos::studies::steady::{
    FoundMotion, LinearisationOptions, Stability, SteadyConditions, SteadyLinearSystem, SymbolicEntry, conditions,
    find_equilibria, linearise, symbolic_linear_system,
};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::{IntegralKind, prove};
use tripos_derive::scene::{StateWithUnknowns, load_state_with_unknowns};

pub fn model(text: &str) -> Mechanism {
    let source = Source::from_text("model.toml", text);
    Mechanism::new(tripos_derive::model::load(&source).unwrap_or_else(|e| panic!("{e}\n{text}")))
}

pub fn loaded(model: &mut Mechanism, state: &str) -> StateWithUnknowns {
    load_state_with_unknowns(&Source::from_text("state.toml", state), model, &[]).unwrap_or_else(|e| panic!("{e}"))
}

fn about(text: &str, state: &str, inputs: &[&str]) -> Result<SteadyLinearSystem, tripos::Error> {
    let inputs: Vec<String> = inputs.iter().map(|name| (*name).to_owned()).collect();
    let mut model = model(text);
    model.model = model.model.reread_with_varied_inputs(&inputs).unwrap_or_else(|e| panic!("{e}"));
    let asked = loaded(&mut model, state);
    linearise(&model, &asked, &LinearisationOptions { inputs, ..LinearisationOptions::default() })
}

pub fn rests(text: &str, state: &str, starts: u64) -> Vec<FoundMotion> {
    let mut model = model(text);
    let asked = loaded(&mut model, state);
    find_equilibria(&model, &asked, starts).unwrap_or_else(|e| panic!("{e}"))
}

pub fn closed(text: &str) -> SteadyConditions {
    conditions(&model(text), &[]).unwrap_or_else(|e| panic!("{e}"))
}

/// A bead on a hoop that a motor turns about the vertical.
fn hoop(radius: f64, turn: f64, angle: &str) -> String {
    format!(
        r#"
name = "Bead on a hoop"
[parameters]
m = {{ unit = "kg", value = 0.05, positive = true }}
R = {{ unit = "m", value = {radius:?}, positive = true }}
w = {{ unit = "rad/s", value = {turn:?} }}
g = "9.81 m/s^2"
[coordinates]
th = {{ unit = "rad" }}
[speeds]
u = "th'"
[inertial]
frame = "N"
origin = "O"
[frames]
H = {{ from = "N", axis = 3, angle = "{angle}" }}
B = {{ from = "H", axis = 2, angle = "th" }}
[points]
P = {{ from = "O", frame = "B", position = [0, 0, "-R"] }}
[particles]
bead = {{ point = "P", mass = "m" }}
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#
    )
}

/// Goal: a mechanism driven at a constant rate has equilibria, since its equations do not depend on time, though the
/// file does. Method: the bead rests at cos θ = g/(R w²) and swings there with w sin θ, in closed form too. Driven
/// unevenly it is refused, with the speed whose rate depends on time.
#[test]
fn a_bead_rests_on_a_hoop_that_turns() {
    for (radius, turn) in [(0.05_f64, 16.0_f64), (0.4, 7.5), (1.0, 4.0)] {
        let text = hoop(radius, turn, "w*t");
        let found = about(&text, "[state]\nu = 0\n[guess]\nth = 0.9\n", &[]).unwrap_or_else(|e| panic!("{e}"));
        let theta = (9.81 / (radius * turn * turn)).acos();
        assert!((found.steady.x[0].hi() - theta).abs() < 1e-14, "{:?}", found.steady);
        let frequency = turn * theta.sin();
        assert!(found.modes.iter().all(|m| m.is_neutral() && (m.value[1].abs() - frequency).abs() < 1e-12));
        let names: Vec<&str> = found.states().map(|(name, _)| name).collect();
        assert!(found.moves.is_empty() && found.steady.is_rest() && names == ["th", "u"]);
        assert_eq!((found.system.kept.len(), found.stability), (2, Stability::FirstOrder));
        let all = rests(&text, "[state]\nu = 0\n[guess]\nth = 0.9\n", 30);
        assert_eq!(all.len(), 4, "{all:?}");
    }
    let form = closed(&hoop(0.05, 16.0, "w*t"));
    let told: Vec<String> = form.list[0]
        .branches
        .iter()
        .flat_map(|b| &b.solved)
        .map(|t| format!("{} = {}", t.name.text, t.value.text))
        .collect();
    assert!(form.list.len() == 1 && told.contains(&"cos(th) = g/(R*w^2)".to_owned()), "{told:?}");
    let uneven =
        about(&hoop(0.05, 16.0, "w*t + 0.1*sin(w*t)"), "[state]\nu = 0\nth = 0\n", &[]).unwrap_err().to_string();
    assert!(uneven.contains("u' depends on the time t explicitly"), "{uneven}");
}

/// Goal: Jacobi's integral replaces the energy where a drive works, and only there. Method: m R² (u² − w² sin² θ)/2 − m
/// g R cos θ of the bead by its text, at states. Driven unevenly there is none, and on a hoop that stands there is only
/// the energy.
#[test]
fn jacobis_integral_stands_for_the_energy_of_what_is_driven() {
    let of = |angle: &str| {
        let mechanism = model(&hoop(0.05, 16.0, angle));
        let mut derivations = derive_all(&mechanism).unwrap_or_else(|e| panic!("{e:?}"));
        let proof = prove(&mechanism, &mut derivations);
        let arena = &derivations.kinematics.arena;
        let list = proof.integrals.iter();
        list.map(|i| (i.kinds.clone(), tripos_derive::algebra::text::print::print_text(arena, i.expression)))
            .collect::<Vec<_>>()
    };
    let driven = of("w*t");
    let [(kinds, formula)] = driven.as_slice() else { panic!("{driven:?}") };
    assert_eq!(kinds.as_slice(), [IntegralKind::Jacobi]);
    let mut arena = tripos_derive::algebra::Arena::new();
    let e =
        tripos_derive::algebra::text::parse::parse_free(&mut arena, formula).unwrap_or_else(|_| panic!("{formula}"));
    let symbols: Vec<_> = ["m", "R", "w", "g", "th", "u"].map(|name| arena.symbol(name)).to_vec();
    let tape =
        tripos_derive::algebra::value::tape::Tape::new(&arena, &symbols, &[e]).unwrap_or_else(|_| panic!("{formula}"));
    for (th, u) in [(0.3_f64, 1.7_f64), (-2.0, 0.4), (1.1, -3.0)] {
        let (m, r, w, g) = (0.05, 0.05, 16.0, 9.81);
        let truth = m * r * r * (u * u - (w * th.sin()).powi(2)) / 2.0 - m * g * r * th.cos();
        let found = tape.evaluate(&[m, r, w, g, th, u])[0];
        assert!((found - truth).abs() < 1e-15, "{formula}: {found} {truth}");
    }
    assert!(of("w*t + 0.1*sin(w*t)").is_empty());
    let standing = of("0");
    assert!(standing.len() == 1 && standing[0].0 == [IntegralKind::Energy], "{standing:?}");
}

/// Model of a cart that a force pushes, with a pole on it.
fn cart(force: &str) -> String {
    format!(
        r#"
name = "Cart and pole with a push"
[parameters]
M = "1 kg"
m = "0.2 kg"
l = "0.5 m"
g = "9.81 m/s^2"
k = "3 N/m"
[inputs]
F = {{ unit = "N", value = "{force}" }}
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0,"-g",0]
[bodies]
cart = {{ mass = "M", inertia = 0 }}
pole = {{ mass = "m", inertia = "m*l^2/12" }}
[joints]
rail = {{ kind = "slider", axis = 1, body = "cart", coordinates = ["x"], speeds = ["v"] }}
hinge = {{ kind = "pin", body = "pole", to = "cart", centre = [0,"l/2",0], coordinates = ["q"], speeds = ["u"] }}
[forces]
push = {{ on = "cart", frame = "N", vector = ["F",0,0] }}
"#
    )
}

const UP: &str = "[state]\nx = 0\nv = 0\nq = 0\nu = 0\n";

/// Goal: linearisation with a mass as a letter and an input gives the right entries. Method: the upright pole: u'/q = 6
/// g (M + m)/(l (4 M + m)), v'/q = −3 m g/(4 M + m), and by the force 4/(4 M + m) and 6/(l (4 M + m)) with the signs of
/// the model, at four masses.
#[test]
fn a_mass_stays_a_letter_beside_an_input() {
    let mut model = model(&cart("0"));
    let asked = loaded(&mut model, UP);
    let found = linearise(
        &model,
        &asked,
        &LinearisationOptions { inputs: vec!["F".to_owned()], ..LinearisationOptions::default() },
    )
    .unwrap();
    let letters = symbolic_linear_system(&model, &asked, &found, &["M".to_owned()]).unwrap_or_else(|e| panic!("{e}"));
    let kept: Vec<&str> = found.system.kept.iter().map(|at| found.all[*at].as_str()).collect();
    let row = |name: &str| kept.iter().position(|k| *k == name).unwrap();
    let entry = |matrix: usize, of: &str, by: usize| letters.matrices[matrix][row(of)][by].text("M");
    let value = |text: &str, mass: f64| {
        let mut arena = tripos_derive::algebra::Arena::new();
        let e = tripos_derive::algebra::text::parse::parse_free(&mut arena, text).unwrap_or_else(|_| panic!("{text}"));
        let symbol = arena.symbol("M");
        tripos_derive::algebra::value::tape::Tape::new(&arena, &[symbol], &[e]).unwrap().evaluate(&[mass])[0]
    };
    let (m, l, g) = (0.2, 0.5, 9.81);
    for mass in [0.3, 1.0, 2.5, 40.0] {
        let by = 4.0 * mass + m;
        let checks = [
            (entry(0, "u", row("q")), 6.0 * g * (mass + m) / (l * by)),
            (entry(0, "v", row("q")), -3.0 * m * g / by),
            (entry(1, "v", 0), 4.0 / by),
            (entry(1, "u", 0), -6.0 / (l * by)),
        ];
        for (text, truth) in checks {
            let found = value(&text, mass);
            assert!(
                (found.abs() - f64::abs(truth)).abs() < 1e-12 * f64::abs(truth),
                "{text} at {mass}: {found}, {truth}"
            );
        }
        let signs = [value(&entry(0, "u", row("q")), mass) > 0.0, value(&entry(1, "v", 0), mass) > 0.0];
        assert_eq!(signs, [true, true]);
    }
    assert!(!matches!(letters.matrices[0][row("u")][row("q")], SymbolicEntry::Polynomial(_)));
}

/// Goal: an input whose default is a formula is treated like other inputs. Method: B of the cart equals that of a
/// number, and A has the slopes that a formula of the place brings.
#[test]
fn an_input_that_is_a_formula_has_its_column() {
    let number = about(&cart("0"), UP, &["F"]).unwrap();
    for (formula, stiff) in [("(M - 5*m)*g", 0.0), ("-k*x", -3.0)] {
        let found = about(&cart(formula), UP, &["F"]).unwrap_or_else(|e| panic!("{formula}: {e}"));
        let place = |found: &SteadyLinearSystem, name: &str| {
            found.system.kept.iter().position(|at| found.all[*at] == name).unwrap_or_else(|| panic!("{name}"))
        };
        for speed in ["v", "u"] {
            let of = |found: &SteadyLinearSystem| found.system.b.doubles()[place(found, speed)][0];
            assert!((of(&found) - of(&number)).abs() < 1e-14 && of(&found).abs() > 0.5, "{formula}: {speed}");
            if stiff != 0.0 {
                let slope = found.system.a.doubles()[place(&found, speed)][place(&found, "x")];
                assert!((slope - stiff * of(&number)).abs() < 1e-13, "{formula}: {speed}");
            }
        }
    }
}

const BOB: &str = r#"
name = "Bob on a rod whose upper end slides on a rail, by the bob's height"
[parameters]
m = "1.3 kg"
M = "2 kg"
L = "0.9 m"
g = "9.81 m/s^2"
k = "7 N/m"
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
s = { unit = "m" }
[speeds]
w = "s'"
vy = "y'"
[inertial]
frame = "N"
origin = "O"
[points]
S = { from = "O", frame = "N", position = ["s", 0, 0] }
P = { from = "O", frame = "N", position = ["x", "y", 0] }
[particles]
slider = { point = "S", mass = "M" }
bob = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[forces]
spring = { on = "slider", frame = "N", vector = ["-k*s", 0, 0] }
[constraints]
rod = { equation = "distance(S, P) = L" }
"#;

/// Goal: no linear system is given where the speeds do not determine the rates of the coordinates. Method: a bob by its
/// height, which has no rate where it hangs. By its place it hangs well, s'' and x'' as of a pendulum on a slider.
/// Likewise a speed q' cos q at q = 90°.
#[test]
fn poles_are_refused_by_name() {
    let state = "[state]\nw = 0\nvy = 0\n[guess]\nx = 0.2\ny = -0.8\ns = 0.1\n";
    let refused = about(BOB, state, &[]).unwrap_err().to_string();
    assert!(refused.contains("they divide by") && refused.contains('x') && refused.contains('s'), "{refused}");
    let by_place = BOB.replace("vy = \"y'\"", "vx = \"x'\"");
    let found = about(&by_place, &state.replace("vy", "vx"), &[]).unwrap_or_else(|e| panic!("{e}"));
    // With d = x − s, both m d'' and M s'' follow from gravity, m g d/L on each, and the spring.
    let (m, big, l, g, k) = (1.3, 2.0, 0.9, 9.81, 7.0);
    let (a, b, c) = (1.0, (k / big) + g * (m + big) / (big * l), k * g / (big * l));
    let root = f64::sqrt(b * b - 4.0 * a * c);
    for square in [(b - root) / 2.0, f64::midpoint(b, root)] {
        let wanted = f64::sqrt(square);
        assert!(found.modes.iter().any(|mode| (mode.value[1] - wanted).abs() < 1e-12), "{wanted}: {:?}", found.modes);
    }
    assert_eq!(found.stability, Stability::Energy);
    let turned = hoop(1.0, 1.0, "0").replace("u = \"th'\"", "u = \"th'*cos(th)\"");
    let state = "[parameters]\ng = 0\n[state]\nu = 0\nth = \"pi/2\"\n";
    let refused = about(&turned, state, &[]).unwrap_err().to_string();
    assert!(refused.contains("cos(th)"), "{refused}");
}

/// Goal: no linear system is given where a speed has no inertia. Method: a bob on a rod, by its angle from the vertical
/// and its heading. A search that begins beside the vertical comes to it; there the heading has no meaning.
#[test]
fn a_pose_in_which_a_speed_has_no_inertia_is_refused() {
    let model = r#"
name = "s27"
[parameters]
g = { unit = "m/s^2", value = 9.81 }
l1 = { unit = "m", value = 0.48, positive = true }
m1 = { unit = "kg", value = 0.86, positive = true }
[coordinates]
ph = { unit = "rad" }
q1 = { unit = "rad" }
[speeds]
u_ph = "ph'"
u_q1 = "q1'"
[inertial]
frame = "N"
origin = "O"
[frames]
H = { from = "N", axis = 3, angle = "ph" }
B1 = { from = "H", axis = 2, angle = "q1" }
[points]
P1 = { from = "O", frame = "B1", position = [0, 0, "-l1"] }
[particles.pt1]
point = "P1"
mass = "m1"

[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#;
    let found = rests(model, "[state]\nph = 0\nu_ph = 2.12\nu_q1 = 0\n[guess]\nq1 = -0.8\n", 0);
    assert!(!found.is_empty());
    for one in &found {
        let why = one.about.as_ref().unwrap_err().to_string();
        assert!(why.contains("the mass matrix is singular") && why.contains("u_ph"), "{why}");
    }
    // Where the rod swings around, the state is regular: the bob turns at ph'² = g/(l cos q1).
    let (l, g, q1) = (0.48_f64, 9.81_f64, 0.5_f64);
    let turn = (g / (l * q1.cos())).sqrt();
    let state = format!("[state]\nph = 0\nu_ph = {turn}\nu_q1 = 0\n[guess]\nq1 = 0.45\n");
    let steady = about(model, &state, &[]).unwrap_or_else(|error| panic!("{error}"));
    // δq1'' = −(4 cos² + sin²) ph'² δq1 (conical pendulum).
    let wanted = turn * (3.0 * q1.cos().powi(2) + 1.0).sqrt();
    assert!(steady.modes.iter().any(|mode| (mode.value[1].abs() - wanted).abs() < 1e-9), "{:?}", steady.modes);
}

/// Goal: a transfer function is not left out where equal carts repeat eigenvalues. Truth: two carts of 0.5 kg on a
/// spring of 15 N/m, one of them pushed, beside one on a spring of 12.5 N/m: 60 (s² + 25) over s² (s² + 60) (s² + 25).
#[test]
fn equal_carts_have_their_transfer_functions() {
    let carts = r#"
name = "Carts"
[parameters]
m = { unit = "kg", value = 0.5, positive = true }
k0 = { unit = "N/m", value = 15.0, positive = true }
k1 = { unit = "N/m", value = 12.5, positive = true }
F = "0 N"
[coordinates]
q0 = { unit = "m" }
q1 = { unit = "m" }
q2 = { unit = "m" }
[speeds]
u0 = "q0'"
u1 = "q1'"
u2 = "q2'"
[inertial]
frame = "N"
origin = "O"
[points]
P0 = { from = "O", frame = "N", position = ["q0", 0, 0] }
P1 = { from = "O", frame = "N", position = ["q1", 0, 0] }
P2 = { from = "O", frame = "N", position = ["q2", 0, 0] }
[particles]
p0 = { point = "P0", mass = "m" }
p1 = { point = "P1", mass = "m" }
p2 = { point = "P2", mass = "m" }
[forces.push]
on = "p0"
frame = "N"
vector = ["F", 0, 0]
[potentials]
s0 = "k0/2*(q1 - q0)^2"
s1 = "k1/2*q2^2"
"#;
    let state = "outputs = [\"q1\"]\n[state]\nq0 = 0\nq1 = 0\nq2 = 0\nu0 = 0\nu1 = 0\nu2 = 0\n";
    let found = about(carts, state, &["F"]).unwrap_or_else(|e| panic!("{e}"));
    let [transfer] = &found.transfers[..] else { panic!("{:?}", found.transfers) };
    let holds = |told: &[f64], truth: &[f64]| {
        assert!(told.len() == truth.len() && told.iter().zip(truth).all(|(a, b)| (a - b).abs() < 1e-9), "{told:?}");
    };
    holds(&transfer.numerator, &[60.0, 0.0, 1500.0]);
    holds(&transfer.denominator, &[1.0, 0.0, 85.0, 0.0, 1500.0, 0.0, 0.0]);
}
