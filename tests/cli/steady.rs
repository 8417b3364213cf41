//! `tripos equilibria` and `tripos linearise`.

use crate::support::{root, tripos_in};
use serde_json::Value;

const V5: &str = "models/whipple_bicycle/steady/v5.toml";

fn tripos(arguments: &[&str]) -> (i32, String, String) {
    tripos_in(&root(), arguments)
}

/// Goal: programs read a linear system by the names of its parts. Method: the bicycle at 5 m/s, with an output; the eigenvalues are the published
/// ones (Meijaard and others 2007), printed to every digit of a double.
#[test]
fn a_linear_system_is_json() {
    let arguments =
        ["linearise", "models/whipple_bicycle", "--about", V5, "--output", "phi + delta", "--symbolic", "v", "--json"];
    let (status, out, err) = tripos(&arguments);
    assert!(status == 0 && err.is_empty(), "{out}{err}");
    let value: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(value["states"], serde_json::json!(["phi", "delta", "u1", "u2", "u3"]));
    assert_eq!(value["C"], serde_json::json!([[1.0, 1.0, 0.0, 0.0, 0.0]]));
    assert_eq!((value["A"].as_array().unwrap().len(), value["observable"].as_u64()), (5, Some(4)));
    let eigenvalues: Vec<(f64, f64)> = value["eigenvalues"]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| (v[0].as_f64().unwrap(), v[1].as_f64().unwrap()))
        .collect();
    let published = [
        (-0.322_866_429_004_087_1, 0.0),
        (-0.775_341_882_195_841_9, 4.464_867_713_788_225),
        (-14.078_389_692_798_247, 0.0),
    ];
    for (re, im) in published {
        assert!(eigenvalues.iter().any(|(a, b)| (a - re).hypot(b - im) < 1e-13), "{re} {im} {eigenvalues:?}");
    }
    assert!(value["residual"].as_f64().unwrap() < 1e-25, "{}", value["residual"]);
    let slope = value["symbolic"]["A"][3][1].as_str().unwrap();
    assert!(slope.starts_with("30.9087533932") && slope.ends_with("*v^2"), "{slope}");
}

/// Goal: people see what changes with speed, and where. Method: the bicycle from 4 to 7 m/s passes its weave and its capsize speed.
#[test]
fn a_steady_motion_is_followed_along_a_number() {
    let (status, out, err) = tripos(&["equilibria", "models/whipple_bicycle", "--from", V5, "--over", "v=4:7:4"]);
    assert!(status == 0 && err.is_empty(), "{out}{err}");
    assert!(out.contains("v = 4: unstable; 0.413253315 ± 3.079108186i"), "{out}");
    assert!(out.contains("v = 4.29238253634") && out.contains("v = 6.02426201538"), "{out}");
}

/// Goal: every way to be wrong is told with what to do. Method: one of each.
#[test]
fn wrong_questions_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = |text: &str| {
        let path = folder.path().join("state.toml");
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let cases = [
        ("[state]\ntheta = 0.5\nomega = 0\n", vec![], "is not an equilibrium"),
        ("[state]\ntheta = 0\n", vec![], "no value is given to omega"),
        ("[state]\ntheta = 0\nomega = 0\n[guess]\ntheta = 1\n", vec![], "stated and guessed"),
        ("[names]\nl = 1\n[state]\ntheta = 0\nomega = 0\n", vec![], "`l` is a name of the model"),
        ("[state]\ntheta = 0\nomega = 0\n", vec!["--input", "force"], "no input `force`"),
        ("[state]\ntheta = 0\nomega = 0\n", vec!["--output", "thta"], "unknown name `thta`"),
        ("[state]\ntheta = 0\nomega = 0\n", vec!["--symbolic", "x"], "there is no `x`"),
    ];
    for (text, more, expected) in cases {
        let path = file(text);
        let arguments: Vec<&str> = ["linearise", "models/pendulum", "--about", &path].into_iter().chain(more).collect();
        let (status, out, err) = tripos(&arguments);
        assert!(status == 2 && err.contains(expected) && err.contains("help:"), "{expected}: {out}{err}");
    }
    let path = file("[state]\ntheta = 0\nomega = 0\n");
    for over in ["g", "g=1:2", "g=1:2:1", "q=1:2:3", "g=a:2:3"] {
        let (status, _, err) = tripos(&["equilibria", "models/pendulum", "--from", &path, "--over", over]);
        assert!(status == 2 && err.contains("help:"), "{over}: {err}");
    }
}
