//! Contacts with friction that open, share a slip, jam or have no friction, and features that do not support friction.

use crate::friction::{BLOCK, FINE, events, falls, happens, keeps_energy, on_plane};
use crate::impacts::{PLANE, end, near, run, scene};
use tripos::Overrides;

/// Goal: a slipping contact opens where nothing presses it. Truth: under a lift m g t/T, T = 1 s, the force is m g (1 −
/// t). The slip is v − μ g (t − t²/2) until 1 s, then stays, and the block rises by g (t − 1)³/6.
#[test]
fn a_block_that_is_lifted_slips_less_and_less_and_opens() {
    let model = BLOCK.to_owned() + "[forces.lift]\non = \"block\"\nframe = \"N\"\nvector = [0, 0, \"m*g*t/T\"]\n";
    let model = model.replace("e = {", "T = { unit = \"s\", value = 1 }\ne = {");
    let run = run(&model, &on_plane("mu = 0.3", 0.0, 4.0, 2.0));
    happens(&run, &[("plane", None), ("plane slips", None), ("plane opens", Some(1.0))]);
    assert!(near(end(&run, "vx"), 2.5, 1e-10) && near(end(&run, "z"), 10.0 / 6.0, 1e-9), "{:?}", run.end);
    keeps_energy(&run, 1e-9);
    // The end of a force is not unbounded growth, whatever rounding leaves at that instant.
    for end in [0.998, 0.999_023, 1.002, 1.3] {
        let model = model.replace("value = 1 }\ne", &format!("value = {end:?} }}\ne"));
        let run = crate::impacts::run(&model, &on_plane("mu = 0.3", 0.0, 4.0, 2.0));
        happens(&run, &[("plane", None), ("plane slips", None), ("plane opens", Some(end))]);
    }
}

/// Goal: at the limit of friction the next instants decide. Truth: a pull of m g (μ + t/T) from rest just reaches the
/// limit at the start, and moves the block by g t³/(6 T).
#[test]
fn a_pull_that_grows_from_the_limit_of_friction_moves_a_block() {
    let model =
        BLOCK.to_owned() + "[forces.pull]\non = \"block\"\nframe = \"N\"\nvector = [\"m*g*(mu + t/T)\", 0, 0]\n";
    let model = model.replace("e = {", "T = { unit = \"s\", value = 1 }\ne = {");
    let run = run(&model, &on_plane("mu = 0.3", 0.0, 0.0, 1.0));
    happens(&run, &[("plane", None), ("plane slips", None)]);
    assert!(near(end(&run, "x"), 10.0 / 6.0, 1e-10), "{:?}", run.end);
}

/// A block with two feet on an incline, as a body in a plane.
pub fn feet(mu: f64, vx: f64, span: f64) -> (String, String) {
    let tilted = PLANE.replace("[0, \"-g\", 0]", "[\"g*sin(alpha)\", \"-g*cos(alpha)\", 0]");
    let model = tilted.replace("e = {", "alpha = { unit = \"rad\", value = 0.3 }\ne = {");
    let foot = |name: &str| {
        format!(
            "[impacts.{name}]\ngap = \"p({name}) @ N [2]\"\nrestitution = 0\nfriction = {mu:?}\nalong = \"v({name}) @ N [1]\"\n"
        )
    };
    let text = format!(
        "span = [0, {span:?}]\n[parameters]\na = 0.2\nh = 0.1\nI = 0.05\n[start]\nx = 0\ny = 0.1\nth = 0\nvx = {vx:?}\nvy = 0\nom = 0\n{}{}{FINE}",
        foot("A"),
        foot("B")
    );
    (model, text)
}

/// Goal: two feet of a block, which slip at one velocity, slip, stop and stick together. Truth: a point mass moves
/// alike, though the lower foot bears more.
#[test]
fn a_block_on_two_feet_slides_and_stops_as_a_point_does() {
    let (alpha, g) = (0.3_f64, 9.81);
    let along = |mu: f64| g * (alpha.sin() - mu * alpha.cos());
    let (model, text) = feet(0.2, 0.0, 1.0);
    let slides = run(&model, &text);
    assert!(near(end(&slides, "x"), 0.5 * along(0.2), 1e-10) && end(&slides, "th").abs() < 1e-13, "{:?}", slides.end);
    let (model, text) = feet(0.32, 0.0, 1.0);
    let stays = run(&model, &text);
    assert!(end(&stays, "x").abs() < 1e-13, "{:?}", stays.end);
    assert_eq!(events(&stays).iter().map(|event| event.0).collect::<Vec<_>>(), ["A", "B", "A sticks", "B sticks"]);
    let (model, text) = feet(0.5, 2.0, 3.0);
    let stops = run(&model, &text);
    let t = -2.0 / along(0.5);
    assert!(near(end(&stops, "x"), 0.5 * 2.0 * t, 1e-10) && end(&stops, "vx").abs() < 1e-14, "{:?}", stops.end);
    assert_eq!(events(&stops)[4..], [("A sticks", Some(stops.events()[4].t)), ("B sticks", Some(stops.events()[4].t))]);
    assert!(near(stops.events()[4].t, t, 1e-11));
    keeps_energy(&stops, 1e-10);
}

/// A bar that hangs from a point that rises and rests with its tip on a belt.
const SPRAG: &str = r#"
name = "Bar on a belt"
[parameters]
m = { unit = "kg", value = 1, positive = true }
L = { unit = "m", value = 1, positive = true }
g = { unit = "m/s^2", value = 9.81 }
h = { unit = "m", value = 0.5403023058681398 }
r = { unit = "m/s", value = 0.1 }
[coordinates]
th = { unit = "rad" }
[speeds]
om = "th'"
[inertial]
frame = "N"
origin = "O"
[frames]
F = { from = "N", axis = 2, angle = "th" }
[points]
Q = { from = "O", frame = "N", position = [0, 0, "h + r*t"] }
T = { from = "Q", frame = "F", position = [0, 0, "-L"] }
[particles]
tip = { point = "T", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#;

/// Goal: the run ends with its reason where friction increases the normal force without bound, even if the motion is
/// smooth. Truth: a bar at the angle θ that a belt draws under it has λ (sin θ − μ cos θ) = m g sin θ + …, which is
/// unbounded at tan θ = μ. There h + r t = L cos θ.
#[test]
fn a_bar_jams_on_a_belt_where_friction_feeds_itself() {
    let mu = 0.8_f64;
    let jams = (mu.atan().cos() - 1.0_f64.cos()) / 0.1;
    let om = -0.1 / 1.0_f64.sin();
    let text = format!(
        "span = [0, 4]\n[start]\nth = 1\nom = {om:?}\n[impacts.tip]\ngap = \"p(T) @ N [3]\"\nrestitution = 0\nfriction = {mu:?}\nalong = \"v(T) @ N [1] - 3\"\n{FINE}"
    );
    let run = scene(SPRAG, &text).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
    let why = run.failure().unwrap_or_else(|| panic!("{:?}", run.end));
    assert!(run.solution.stop.code() == "friction" && why.contains("is not determined"), "{why}");
    assert!(near(run.solution.t_end, jams, 1e-6), "{} for {jams}", run.solution.t_end);
}

/// Goal: a coefficient of 0 gives a smooth contact. Truth: the block slides by g sin α, and lies still where nothing
/// pulls it.
#[test]
fn without_a_coefficient_a_contact_is_smooth() {
    let slides = run(BLOCK, &on_plane("mu = 0\nalpha = 0.3", 0.0, -1.0, 1.0));
    assert!(near(end(&slides, "x"), -1.0 + 5.0 * 0.3_f64.sin(), 1e-11), "{:?}", slides.end);
    happens(&slides, &[("plane", None), ("plane slips", None)]);
    let lies = run(BLOCK, &on_plane("mu = 0", 0.0, 0.0, 1.0));
    assert!(end(&lies, "x").abs() < 1e-15 && lies.events().len() == 2, "{:?}", lies.events());
}

/// Goal: the run ends where Newton's law with friction creates energy, as it may. Truth: sticking, it gives ½ Λ (v⁻ +
/// v⁺) = 0.3 J here, by G of the rod.
#[test]
fn an_impact_with_friction_that_creates_energy_is_refused() {
    let text = falls(0.9, 1.0, 0.0, "restitution = 0.9\nfriction = 0.9");
    let run = scene(PLANE, &text).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
    let why = run.failure().unwrap_or_else(|| panic!("{:?}", run.impacts()));
    assert!(why.contains("would create energy") && why.contains("law = \"poisson\""), "{why}");
    let calm = text.replace("restitution", "law = \"poisson\"\nrestitution");
    let run = scene(PLANE, &calm).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
    assert!(run.failure().is_none() && run.impacts()[0].loss > 0.0, "{:?}", run.objections());
}

/// Goal: a disk that bounces ever shorter while it spins ends up rolling. Truth: the total loss of slip equals that of
/// one long contact, as friction follows the normal impulses. For a disk, v after is v − s/3 of the slip s.
#[test]
fn a_disk_that_bounces_ends_up_rolling() {
    let text = format!(
        "span = [0, 4]\n[parameters]\nI = 0.375\na = 0.5\n[start]\nx = 0\ny = 1\nth = 0\nvx = 1\nvy = 0\nom = 4\n[impacts.floor]\ngap = \"y - a\"\nrestitution = 0.5\n\
         friction = 0.1\nalong = \"vx + a*om\"\n{FINE}"
    );
    let run = run(PLANE, &text);
    assert!(near(end(&run, "vx"), 1.0 - 3.0 / 3.0, 1e-9) && near(end(&run, "om"), 0.0, 1e-9), "{:?}", run.end);
    assert!(run.impacts().len() > 15 && !run.impacts().last().unwrap().held.is_empty());
    keeps_energy(&run, 1e-9);
}

/// Goal: a coefficient can be set like any parameter, and a negative one is refused.
#[test]
fn a_coefficient_is_set_like_any_parameter() {
    let mut scene = scene(BLOCK, &on_plane("alpha = 0.3", 0.0, 0.0, 1.0));
    scene.set_number("mu", 0.2).unwrap();
    let run = scene.simulate(&Overrides::default()).unwrap();
    assert!(near(end(&run, "x"), 5.0 * (0.3_f64.sin() - 0.2 * 0.3_f64.cos()), 1e-10), "{:?}", run.end);
    assert!(scene.set_number("mu", -0.2).unwrap_err().to_string().contains("below 0"));
}
