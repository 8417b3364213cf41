//! `tripos scene`, and runs by a scene's reduced equations.

use crate::support::{answer, answer_in_json, root};
use serde_json::Value;

fn names(value: &Value) -> Vec<&str> {
    value.as_array().unwrap().iter().map(|v| v.as_str().unwrap()).collect()
}

/// The state of the disk at t = 10 s of the report's start: DOP853 in 32 digits by Lagrange's and by Kane's equations,
/// which differ by
/// 1.3e-17.
const CERTIFIED: [(&str, f64); 10] = [
    ("q1", -35.008_636_958_090_84),
    ("q2", 0.315_575_822_684_061_65),
    ("q3", 36.165_617_389_122_275),
    ("q4", 9.299_355_130_494_183),
    ("q5", 1.328_870_649_551_277_2),
    ("u1", -1.664_453_786_444_841),
    ("u2", -0.001_286_560_843_161_506_5),
    ("u3", 0.020_348_994_967_025_01),
    ("u4", 1.107_208_990_148_501_6),
    ("u5", 1.425_306_238_430_56),
];

const LEAN: &str = "models/disk/scenes/lean.toml";
const REPORT: &str = "models/disk/scenes/report-10s.toml";

#[test]
fn the_ledger_of_the_lean_scene_says_what_is_left_of_ten_states() {
    let ledger = answer_in_json(&["scene", LEAN, "--json"]);
    assert_eq!(names(&ledger["states"]), ["q2", "u1"]);
    assert!(ledger["quadratures"].as_array().unwrap().is_empty());
    let [full, scene] = ["full", "scene"].map(|key| ledger["operations"][key].as_u64().unwrap());
    assert!(100 * scene <= 45 * full, "{scene} of {full} operations");
    let omitted = ledger["omitted"].as_array().unwrap();
    for state in ["q1", "q3", "q4", "q5", "u2", "u4", "u5"] {
        let entry =
            omitted.iter().find(|o| o["what"] == state).unwrap_or_else(|| panic!("{state} is not in the account"));
        assert!(["why", "proof"].iter().all(|key| !entry[key].as_str().unwrap().is_empty()), "{entry}");
    }
    let (status, text, _) = answer(&["scene", LEAN]);
    assert!(status == 0 && text.contains("kept, of 10 states") && text.contains("left out"), "{text}");
}

/// Goal: ten outputs in plain doubles, to 1e-12. Method: the certified state, by steps and by quadrature.
#[test]
fn ten_outputs_after_ten_seconds_are_exact_to_1e_12() {
    let taylor = ["--method", "taylor", "--rtol", "1e-15", "--atol", "1e-15", "--project", "energy"];
    for how in [&taylor[..], &["--method", "quadrature"]] {
        let run = answer_in_json(&[&["simulate", REPORT, "--json"][..], how].concat());
        assert_eq!((run["formulation"].as_str(), run["compiled"].as_bool()), (Some("reduced"), Some(true)));
        for (name, exact) in CERTIFIED {
            let error = (run["state"][name].as_f64().unwrap() - exact).abs() / (1.0 + exact.abs());
            assert!(error < 1e-12, "{how:?}: {name} is off by {error:e}");
        }
        let projected = &run["projection"];
        assert_eq!(projected.is_object(), how.len() > 2);
        assert!(!projected.is_object() || projected["removed"][0].as_f64().is_some_and(|x| x != 0.0), "{projected}");
    }
}

/// Goal: no stale slice. Method: a copy of a scene whose outputs are edited between runs.
#[test]
fn edited_outputs_are_there_in_the_next_run() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("edited.toml");
    let text = std::fs::read_to_string(root().join(LEAN)).unwrap();
    let model = root().join("models/disk/model.toml");
    let scene = path.to_str().unwrap();
    let write = |outputs: &str| {
        let text = text.replace("outputs = [\"q2\", \"u1\"]", &format!("outputs = {outputs}"));
        std::fs::write(&path, format!("model = {:?}\n{text}", model.to_str().unwrap())).unwrap();
    };
    write("[\"q2\", \"u1\"]");
    let lean = answer_in_json(&["simulate", scene, "--json"]);
    assert_eq!((lean["state"].as_object().unwrap().len(), lean["compiled"].as_bool()), (2, Some(true)));
    write("[\"q1\", \"N\", \"u1'\", { name = \"height\", value = \"R*cos(q2)\" }, \"total_energy\"]");
    let more = answer_in_json(&["simulate", scene, "--json"]);
    let shown: std::collections::BTreeSet<&str> =
        more["state"].as_object().unwrap().keys().map(String::as_str).collect();
    assert_eq!(shown, ["q1", "N", "u1'", "height", "total_energy"].into());
    let (height, energy) = (more["state"]["height"].as_f64().unwrap(), more["state"]["total_energy"].as_f64().unwrap());
    // The start: T + V of the report's program with V = 0 upright, by hand; the height is R cos q2.
    let certified = 0.315_575_822_684_061_65_f64.cos();
    assert!((height - certified).abs() < 1e-4, "{height}");
    assert!(energy.is_finite() && more["state"]["N"].as_f64().is_some_and(|n| n > 0.0), "{more}");
}

#[test]
fn what_equations_do_not_contain_is_refused_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("asks.toml");
    let text = std::fs::read_to_string(root().join(LEAN)).unwrap();
    let text = text.replace("outputs = [\"q2\", \"u1\"]", "outputs = [\"bounce\"]");
    std::fs::write(&path, format!("model = {:?}\n{text}", root().join("models/disk/model.toml").to_str().unwrap()))
        .unwrap();
    let (status, _, err) = answer(&["scene", path.to_str().unwrap()]);
    assert!(status == 2 && err.contains("bounce") && err.contains("state the contact under [impacts]"), "{err}");
    let (status, _, err) = answer(&["simulate", REPORT, "--by", "kane", "--method", "quadrature"]);
    assert!(status == 2 && err.contains("one degree of freedom"), "{err}");
    let (status, _, err) = answer(&["simulate", REPORT, "--by", "kane", "--project", "energy"]);
    assert!(status == 2 && err.contains("reduced equations"), "{err}");
}

/// Goal: an event on a coordinate that would be computed from the time is found where it happens. Method: the same by
/// Kane's equations.
#[test]
fn an_event_on_a_coordinate_that_time_would_carry_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("watched.toml");
    let text = std::fs::read_to_string(root().join(LEAN)).unwrap();
    let model = root().join("models/disk/model.toml");
    let event = "[[events]]\nname = \"there\"\nzero = \"q4 - 5.2*R\"\nterminal = true\n";
    std::fs::write(&path, format!("model = {:?}\n{text}\n{event}", model.to_str().unwrap())).unwrap();
    let at = |more: &[&str]| {
        let run = answer_in_json(&[&["simulate", path.to_str().unwrap(), "--json"][..], more].concat());
        assert_eq!(run["stop"], "event:there", "{run}");
        run["t"].as_f64().unwrap()
    };
    let (own, kane) = (at(&[]), at(&["--by", "kane"]));
    assert!((own - kane).abs() < 1e-7, "{own} and {kane}");
}

/// Goal: the energies of a table are those of the model, though reduced equations have others. Method: Kane's, at the
/// start.
#[test]
fn a_table_has_the_energies_of_the_whole_model() {
    let folder = tempfile::tempdir().unwrap();
    let first = |name: &str, more: &[&str]| -> Vec<f64> {
        let path = folder.path().join(name);
        let scene = "models/spherical_pendulum/scenes/wide.toml";
        let (status, _, err) = answer(&[&["simulate", scene, "--csv", path.to_str().unwrap()][..], more].concat());
        assert_eq!(status, 0, "{err}");
        let text = std::fs::read_to_string(&path).unwrap();
        let line = text.lines().nth(1).unwrap();
        line.split(',').map(|x| x.parse().unwrap()).collect()
    };
    let (own, kane) = (first("own.csv", &[]), first("kane.csv", &["--by", "kane"]));
    assert!(own.len() == kane.len() && own[5] > 0.2, "{own:?}");
    assert!(own.iter().zip(&kane).all(|(a, b)| (a - b).abs() < 1e-13), "{own:?}\n{kane:?}");
}

/// A scene whose own equations carry as much and cost as much as the whole ones gains nothing by them.
#[test]
fn whole_equations_run_where_the_scene_s_own_are_no_gain() {
    let fall = "models/cart_pendulum_3/scenes/fall.toml";
    let whole = answer_in_json(&["simulate", fall, "--until", "0.5", "--json"]);
    let why = whole["notes"][0].as_str().unwrap();
    let why = why.strip_prefix("the full equations are integrated: ").unwrap_or_else(|| panic!("{why}"));
    assert!(why.starts_with("the scene's reduced equations carry all 8 variables"), "{why}");
    let scene = answer_in_json(&["scene", fall, "--json"]);
    assert_eq!((&whole["formulation"], &scene["runs_whole"]), (&"kane".into(), &why.into()));
    let own = answer_in_json(&["simulate", fall, "--until", "0.5", "--by", "reduced", "--json"]);
    assert_eq!((&own["formulation"], &own["notes"]), (&"reduced".into(), &Value::Array(Vec::new())));
    for (name, x) in whole["state"].as_object().unwrap() {
        let difference = x.as_f64().unwrap() - own["state"][name].as_f64().unwrap();
        assert!(difference.abs() < 1e-7, "{name}: {difference:e}");
    }
    assert_eq!(answer_in_json(&["scene", LEAN, "--json"])["runs_whole"], Value::Null);
}

const FURUTA: &str = r#"
name = "Furuta pendulum"
[parameters]
J = { unit = "kg*m^2", value = 0.01, positive = true }
L1 = { unit = "m", value = 0.2, positive = true }
l2 = { unit = "m", value = 0.15, positive = true }
m2 = { unit = "kg", value = 0.1, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
b = { unit = "N*m*s", value = 0.002 }
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
[speeds]
u1 = "q1'"
u2 = "q2'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q1" }
B = { from = "A", axis = 1, angle = "q2" }
[points]
P = { from = "O", frame = "A", position = ["L1", 0, 0] }
C = { from = "P", frame = "B", position = [0, 0, "-l2"] }
[bodies.arm]
frame = "A"
centre = "O"
mass = 0
inertia = { diagonal = ["J/2", "J/2", "J"] }
[bodies.rod]
frame = "B"
centre = "C"
mass = "m2"
inertia = { diagonal = ["m2*l2^2/3", "m2*l2^2/3", 0] }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#;

/// The momentum about the pivot determines the arm's speed by its inertia there, which positive parameters let be zero
/// nowhere; and what is computed once is called by what it is.
#[test]
fn what_is_zero_nowhere_is_no_singular_place() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), FURUTA).unwrap();
    let scene = "model = \"model.toml\"\nspan = [0, 1]\n[start]\nq1 = 0\nq2 = 1\nu1 = 0\nu2 = 0\n";
    std::fs::write(folder.path().join("scene.toml"), scene).unwrap();
    let ledger = answer_in_json(&["scene", folder.path().join("scene.toml").to_str().unwrap(), "--json"]);
    assert_eq!((&ledger["singular_where"], names(&ledger["states"])), (&Value::Array(Vec::new()), vec!["q2", "u2"]));
    let constants = ledger["constants"].as_array().unwrap();
    let called = |name: &str| constants.iter().find(|c| c["name"] == name).map(|c| c["is"].clone());
    assert_eq!(called("L1_squared_times_3"), Some("3*L1^2".into()), "{constants:?}");
}

/// Bodies on one that turns in a plane, and a bead on one of them. A scene that shows the kinetic energy alone has a
/// moving frame, which passes its pole at t = 0.2117 s.
const FRAME_POLE: &str = r#"
name = "Bodies in a plane"

[parameters]
g1 = { unit = "m/s^2", value = 9.81, positive = true }
m2 = { unit = "kg", value = 1.183, positive = true }
I3 = { unit = "kg*m^2", value = 0.201, positive = true }
Jz8 = { unit = "kg*m^2", value = 0.021, positive = true }
m9 = { unit = "kg", value = 2.181, positive = true }
Jz12 = { unit = "kg*m^2", value = 0.068, positive = true }

[coordinates]
s = { unit = "m" }

[speeds]
us = "s'"

[inertial]
frame = "N"
origin = "O"

[points]
S = { from = "J2", frame = "b2_frame", position = [0, "s", 0] }

[bodies]
b1 = { mass = "m2", inertia = { diagonal = ["I3*1.058", "I3*1.086", "I3*1.192"] } }
b2 = { mass = "m2", inertia = "Jz8" }
b3 = { mass = "m9", inertia = "Jz12" }

[particles]
bead = { point = "S", mass = "m9" }

[joints]
J1 = { kind = "pin", body = "b1", axis = 3 }
J2 = { kind = "slider", body = "b2", to = "b1", axis = 1 }
J3 = { kind = "planar", body = "b3", to = "b1", axis = 3 }

[gravity]
frame = "N"
acceleration = [0, "-g1", 0]
"#;
const PASSES_POLE: &str = r#"model = "model.toml"
span = [0.0, 0.785193420529145]
outputs = ["kinetic_energy"]
[start]
s = -0.3453298788214384
q_J1 = -0.8668461657124722
q_J2 = 0.1381338855726577
q_J3_1 = 0.2755248155011354
q_J3_2 = 0.2452664559783232
q_J3_3 = -0.49685713732090586
"s'" = 0.14151286083063996
"q_J1'" = 0.5670786197384732
"q_J2'" = -0.6552160137333458
"q_J3_1'" = -0.03831008555366244
"q_J3_2'" = -0.1439338138334536
"q_J3_3'" = -0.6228571985652478
[integration]
"#;

/// Goal: a default run never stops where the full equations do not. Truth: Lagrange's and Kane's equations, which
/// agree.
#[test]
fn a_default_run_goes_over_to_whole_equations_where_its_frame_has_a_pole() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), FRAME_POLE).unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, PASSES_POLE).unwrap();
    let path = path.to_str().unwrap();
    let fine = ["--method", "dop853", "--rtol", "1e-11", "--atol", "1e-11"];
    let run = |more: &[&str]| answer_in_json(&[&["simulate", path, "--json"], &fine[..], more].concat());
    let (own, kane, lagrange) = (run(&[]), run(&["--by", "kane"]), run(&["--by", "lagrange"]));
    let energy = |run: &Value| run["state"]["kinetic_energy"].as_f64().unwrap();
    assert!((energy(&kane) - energy(&lagrange)).abs() < 1e-8, "{} {}", energy(&kane), energy(&lagrange));
    assert!((energy(&own) - energy(&kane)).abs() < 1e-8, "{} {}", energy(&own), energy(&kane));
    assert!((own["t"].as_f64().unwrap() - 0.785_193_420_529_145).abs() < 1e-12);
    let notes = own["notes"].to_string();
    assert!(
        notes.contains("the full equations are integrated, by Kane's method, since the scene's own stop at t = 0.21"),
        "{notes}"
    );
    // So does a sweep, point by point.
    let table = folder.path().join("table.csv");
    let over = ["--over", "s=-0.3453298788214384,-0.3", "--out", table.to_str().unwrap()];
    let (status, ..) = answer(&[&["sweep", path], &over[..], &fine].concat());
    let table = std::fs::read_to_string(table).unwrap();
    let row: Vec<&str> = table.lines().nth(1).unwrap().split(',').collect();
    assert_eq!((status, row[3]), (0, "end"), "{table}");
    assert!((row[4].parse::<f64>().unwrap() - energy(&kane)).abs() < 1e-8, "{table}");
    let (status, ..) = answer(&[&["simulate", path, "--by", "reduced"], &fine[..]].concat());
    assert_ne!(status, 0, "who asks for the scene's reduced equations gets them alone");
}

/// A symmetric top in Euler's angles, whose momenta stand in its equations only in products.
const TOP: &str = r#"
name = "Symmetric top in Euler's angles, speeds q'"
[parameters]
A = { unit = "kg*m^2", value = 0.7 }
C = { unit = "kg*m^2", value = 0.3 }
k = { unit = "N*m", value = 6 }
m = { unit = "kg", value = 1 }
[coordinates]
phi = { unit = "rad" }
theta = { unit = "rad" }
psi = { unit = "rad" }
[speeds]
u1 = "phi'"
u2 = "theta'"
u3 = "psi'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", sequence = "313", angles = ["phi", "theta", "psi"] }
[bodies.top]
frame = "B"
centre = "O"
mass = "m"
inertia = { diagonal = ["A", "A", "C"] }
[potentials]
weight = "k*cos(theta)"
"#;
const TOP_SCENE: &str = r#"model = "model.toml"
span = [0, 1]
outputs = ["theta"]
[start]
phi = 0
theta = 1
psi = 0
u1 = 0.2
u2 = 0
u3 = 3
[integration]
method = "dop853"
rtol = 1e-10
atol = 1e-12
"#;

/// Goal: a scene's reduced equations have a value, whatever the ratio of the moments. Truth: θ(1) by quadrature of the
/// nutation for A, A, C; for the others Lagrange's equations.
#[test]
fn a_top_runs_by_its_own_equations_whatever_its_moments() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, TOP_SCENE).unwrap();
    let path = path.to_str().unwrap();
    let all: [(f64, f64, &str); 5] =
        [(0.7, 0.3, "313"), (0.7, 0.3, "323"), (0.7, 0.7, "313"), (3.0, 0.5, "313"), (1.0, 0.5, "313")];
    for (a, c, sequence) in all {
        let model = TOP.replace("value = 0.7", &format!("value = {a}")).replace("value = 0.3", &format!("value = {c}"));
        std::fs::write(folder.path().join("model.toml"), model.replace("\"313\"", &format!("\"{sequence}\""))).unwrap();
        let run = |more: &[&str]| answer_in_json(&[&["simulate", path, "--json"], more].concat());
        let (own, other) = (run(&[]), run(&["--by", "lagrange"]));
        let theta = |run: &Value| run["state"]["theta"].as_f64().unwrap();
        assert_eq!(own["formulation"], "reduced", "{a} {c} {sequence}");
        assert!((theta(&own) - theta(&other)).abs() < 1e-8, "{a} {c} {sequence}: {} {}", theta(&own), theta(&other));
        if a.total_cmp(&0.7).is_eq() && c.total_cmp(&0.3).is_eq() {
            assert!((theta(&own) - 1.930_367_933_476_1).abs() < 1e-8, "{sequence}: {}", theta(&own));
        }
    }
}

/// Truth for the numbers: run/tests/abbreviations.rs. Here: the answer as people and programs read it.
#[test]
fn abbreviated_equations_are_printed_with_their_measured_differences() {
    let answer_of =
        |within: &str| answer_in_json(&["scene", "models/furuta/scenes/swing.toml", "--within", within, "--json"]);
    let value = answer_of("0.05");
    let left_out = value["left_out"].as_array().unwrap();
    assert!(!left_out.is_empty() && (left_out.len() as u64) < value["terms"].as_u64().unwrap(), "{value}");
    let operations = |key: &str| value["cost"][key]["operations"].as_u64().unwrap();
    assert!(operations("abbreviated") < operations("whole"), "{value}");
    for difference in value["differences"].as_array().unwrap() {
        let [largest, scale, relative] = ["largest", "scale", "relative"].map(|key| difference[key].as_f64().unwrap());
        assert!(relative <= 0.05 && (largest - relative * scale).abs() <= 1e-12 * scale, "{difference}");
    }
    let (status, text, _) = answer(&["scene", "models/furuta/scenes/swing.toml", "--within", "0.05"]);
    assert!(
        status == 0 && text.contains("with other starts, parameters or spans, differences may be larger"),
        "{text}"
    );
    let (status, _, error) = answer(&["scene", LEAN, "--within", "2"]);
    expect_test::expect![[r"
        2
        error: the bound 2 is not between 1e-10 and 1
        help: state a part of each shown quantity, such as --within 1e-3
    "]]
    .assert_eq(&format!("{status}\n{error}"));
}
