//! Runs say how many of their digits are right, and end where their equations have no value.

use crate::support::{answer, answer_in_json, root};
use serde_json::Value;

/// A file of `tests/data/repro`.
fn given(file: &str) -> String {
    root().join("tests/data/repro").join(file).to_str().unwrap().to_owned()
}

/// A scene of the pendulum, in a folder of its own.
fn pendulum(text: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let model = root().join("models/pendulum/model.toml");
    std::fs::write(&path, format!("model = {:?}\n{text}", model.to_str().unwrap())).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

fn number(run: &Value, list: &str, name: &str) -> f64 {
    run[list][name].as_f64().unwrap_or_else(|| panic!("no number {list}.{name} in {run}"))
}

/// Goal: a run passes a place where its speeds fail. Method: x′ (x/L)² is no speed at x = 0, where the point passes.
/// Under drag alone x = −1/2 + (1 − e⁻ᵗ), and m x′ + c x is conserved, by which the scene's reduced equations go
/// through; a push from the origin leaves only equations in rates: then x″ = −x′ + x.
#[test]
fn a_place_where_speeds_say_nothing_is_passed_by_equations_that_do_not_divide_by_it() {
    let folder = tempfile::tempdir().unwrap();
    let model = std::fs::read_to_string(given("singular/model.toml")).unwrap();
    let pushed = model.replace("-F*T/L*x'", "-F*T/L*x' + F*x/L");
    assert_ne!(model, pushed);
    std::fs::write(folder.path().join("model.toml"), pushed).unwrap();
    std::fs::copy(given("singular/s.toml"), folder.path().join("s.toml")).unwrap();
    let pushed = folder.path().join("s.toml").to_str().unwrap().to_owned();
    let (r, s) = ((5_f64.sqrt() - 1.0) / 2.0, (-1.0 - 5_f64.sqrt()) / 2.0);
    // A eʳᵗ + B eˢᵗ with A + B = −1/2 and r A + s B = 1.
    let b = (1.0 + r / 2.0) / (s - r);
    let ways = [
        (given("singular/s.toml"), "reduced", 0.5 - (-2_f64).exp(), 2_f64.ln()),
        (pushed, "lagrange", (-0.5 - b) * (2.0 * r).exp() + b * (2.0 * s).exp(), (-b / (-0.5 - b)).ln() / (r - s)),
    ];
    for (scene, formulation, right, passes) in ways {
        let run = answer_in_json(&["simulate", &scene, "--json"]);
        let (x, error) = (number(&run, "state", "x"), number(&run, "uncertainty", "x"));
        assert!((x - right).abs() < 1e-6 && (x - right).abs() < 10.0 * error, "{x} ± {error}, not {right}");
        assert_eq!(run["formulation"], formulation);
        let noted = run["notes"].as_array().unwrap().iter().any(|n| n.as_str().unwrap().contains("divide by x"));
        assert_eq!(noted, formulation == "lagrange", "{}", run["notes"]);
        for method in ["ode45", "dop853", "taylor", "gauss6", "radau5"] {
            let (status, out, err) = answer(&["simulate", &scene, "--by", "kane", "--method", method, "--json"]);
            let run: Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{err}"));
            let (t, warned) = (run["t"].as_f64().unwrap(), !run["warnings"].as_array().unwrap().is_empty());
            // A step may be thrown back before it reaches x = 0; a second run then tells.
            assert!((status == 3 && t < passes + 1e-4) || warned, "{method}: {status} at {t}\n{run}");
        }
    }
}

/// Two beads that repel, started 1e-12 beside one another: what decides how they part is 1e-4 of a rounding.
#[test]
fn growth_in_any_direction_is_seen() {
    let run =
        answer_in_json(&["simulate", &given("transverse/s.toml"), "--by", "kane", "--method", "taylor", "--json"]);
    assert!(run["digits"].as_f64().unwrap() < 1.0, "{run}");
    assert!(run["warnings"][0].as_str().unwrap().contains("fewer than three digits are right from t = "), "{run}");
}

/// A pendulum from 5e-8 beside its upright rest: its falls multiply an error by 1e13, and each return takes that back.
#[test]
fn growth_that_goes_back_is_not_forgotten() {
    let (_folder, scene) = pendulum("span = [0, 20]\n[start]\ntheta = 3.1415926\nomega = 0\n");
    let way = ["--method", "taylor", "--rtol", "1e-12", "--atol", "1e-12"];
    let run = answer_in_json(&[&["simulate", &scene, "--json"], &way[..]].concat());
    assert!(run["fewest_digits"]["digits"].as_f64().unwrap() < 1.0 && run["digits"].as_f64().unwrap() < 1.0, "{run}");
    let strict = [&["simulate", &scene, "--strict"], &way[..]].concat();
    assert_eq!((answer(&strict).0, answer(&strict[..2]).0), (3, 0));
}

/// A pendulum that turns over and over.
#[test]
fn a_loose_tolerance_is_no_reason_to_say_nothing() {
    let (_folder, scene) = pendulum("span = [0, 100]\n[start]\ntheta = 0\nomega = 10\n");
    let loose = answer_in_json(&["simulate", &scene, "--method", "dop853", "--rtol", "1e-2", "--json"]);
    let said: Vec<&str> = loose["warnings"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    assert!(said.iter().any(|w| w.contains("fewer than three digits")), "{said:?}");
    // θ is off by 619 rad at the end.
    assert!(number(&loose, "uncertainty", "theta") > 100.0, "{loose}");
    let tight =
        answer_in_json(&["simulate", &scene, "--method", "dop853", "--rtol", "1e-12", "--atol", "1e-12", "--json"]);
    let apart = (number(&loose, "state", "theta") - number(&tight, "state", "theta")).abs();
    let told = number(&loose, "uncertainty", "theta");
    assert!((0.5..2.0).contains(&(told / apart)), "{told} for {apart}");
    assert!(tight["warnings"].as_array().unwrap().is_empty() && tight["digits"].as_f64().unwrap() > 8.0, "{tight}");
}

/// The text shows each number with its error, and how it was assessed.
#[test]
fn each_number_stands_beside_its_error() {
    let (_folder, scene) = pendulum("span = [0, 1]\n[start]\ntheta = 1\nomega = 0\n");
    let (status, out, _) = answer(&["simulate", &scene]);
    let line = out.lines().find(|line| line.starts_with("  theta = ")).unwrap();
    assert!(status == 0 && line.contains(" ± "), "{out}");
    assert!(out.contains("digits are right at the end") && out.contains("a tenth of the tolerances"), "{out}");
}

/// Goal: no run states a work that it did not watch. Method: a damped mass whose outputs leave the energies out; by
/// whole equations the work is that of the damper, by reduced ones it is not known.
#[test]
fn reduced_equations_state_no_work_that_they_do_not_watch() {
    let model = crate::support::SLIDER.replace("\"-k*x\"", "\"-k*x - m*1.5*u/(1*m/k)^(1/2)\"");
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    let scene = "model = \"model.toml\"\nspan = [0, 1]\noutputs = [\"x\"]\n[start]\nx = 1\nu = 0\n";
    std::fs::write(folder.path().join("scene.toml"), scene).unwrap();
    let work = |by: &str| {
        let (status, out, err) =
            crate::support::tripos_in(folder.path(), &["simulate", "scene.toml", "--by", by, "--json"]);
        assert_eq!(status, 0, "{err}");
        serde_json::from_str::<Value>(&out).unwrap()["work"].clone()
    };
    assert!(work("kane").as_f64().is_some_and(|work| work < -0.1), "{}", work("kane"));
    assert!(work("reduced").is_null(), "{}", work("reduced"));
}
