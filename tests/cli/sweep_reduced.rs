//! Sweeps by the reduced equations of a scene: the answers are those of the full equations.

use crate::support::{root, status, stderr, tripos};
use std::collections::HashMap;
use std::path::Path;

type Row = HashMap<String, String>;

/// Rows of a sweep, and the JSON of its summary.
fn sweep(folder: &Path, scene: &Path, arguments: &[&str]) -> (Vec<Row>, serde_json::Value) {
    let out = folder.join("out.csv");
    let fixed = ["sweep", scene.to_str().unwrap(), "--overwrite", "--json", "--out", out.to_str().unwrap()];
    let output = tripos(&[&fixed, arguments].concat());
    assert!([0, 3].contains(&status(&output)), "{}", stderr(&output));
    let rows = csv::Reader::from_path(out).unwrap().deserialize().map(Result::unwrap).collect();
    (rows, serde_json::from_slice(&output.stdout).unwrap())
}

/// Largest difference of the values that two tables share, relative to 1 plus the size of a value.
fn difference(some: &[Row], others: &[Row]) -> f64 {
    assert_eq!(some.len(), others.len());
    let is_value = |name: &str| {
        let other = ["index", "stop", "steps", "rejected", "evaluations", "reason"];
        !other.contains(&name) && !name.starts_with("change of")
    };
    let mut largest = 0.0_f64;
    for (one, other) in some.iter().zip(others) {
        assert_eq!(one["stop"], other["stop"], "{one:?}\n{other:?}");
        for (name, text) in one.iter().filter(|(name, text)| is_value(name) && !text.is_empty()) {
            let (a, b): (f64, f64) = (text.parse().unwrap(), other[name].parse().unwrap());
            largest = largest.max((a - b).abs() / (1.0 + b.abs()));
        }
    }
    largest
}

/// Goal: what a sweep says does not depend on the equations that it chooses. Method: scenes of the library, with
/// starts and parameters that vary, against Kane's equations of the whole model at the same narrow tolerances. Among
/// them are constant momenta, moving frames, quadratures, drives, compiled and interpreted equations.
#[test]
fn rows_by_reduced_equations_are_those_of_the_full_equations() {
    let tight = ["--method", "dop853", "--rtol", "1e-12", "--atol", "1e-13"];
    let folder = tempfile::tempdir().unwrap();
    let mut reduced = 0;
    for (scene, over, until) in [
        ("disk/scenes/lean", &["q2=-1.2:1.3:5", "q1'=0,0.4"][..], "2"),
        // Away from the flat pose, where Kane's equations lose digits: against quadrature, they have errors of 2e-8
        // after 1 s from a lean of 1.3, and the reduced equations 2e-11.
        ("disk/scenes/report-10s", &["q2=-0.8:0.9:4", "q4'=-1,0"], "0.5"),
        ("disk/scenes/lean", &["g=1.62,9.81", "R=0.5,2"], "2"),
        ("cart_with_spring/scenes/released", &["x=-0.1,0.2,0.3"], "2"),
        ("chaotic_pendulum/scenes/swing", &["theta=0.5,1", "phi=0.1,2"], "1"),
        ("driven_pendulum/scenes/falling", &["q=0.2,1"], "1"),
        ("euler_top/scenes/looping", &["theta=-0.9,0.3,4", "u3=30,55"], "0.5"),
        ("floating_chain/scenes/folding", &["theta2=0.1,0.6"], "0.5"),
        ("free_body/scenes/tumbling", &["theta=0.2,0.4"], "1"),
        ("furuta/scenes/swing", &["theta2=0.3,2"], "0.5"),
        ("gimbals/scenes/nutation", &["theta=0.4,-0.5"], "0.5"),
        ("heavy_top/scenes/waking", &["q1=0,0.1", "u1=0.01,0.2"], "1"),
        ("knife_edge/scenes/cycloid", &["phi=0.2,2"], "1"),
        ("pendulum/scenes/swing", &["theta=0.2,3", "l=1,2"], "2"),
        ("spherical_pendulum/scenes/wide", &["theta=0.5,2,4", "phi'=0.3,2"], "1"),
    ] {
        let path = root().join(format!("models/{scene}.toml"));
        let over: Vec<&str> = over.iter().flat_map(|axis| ["--over", axis]).collect();
        let arguments = [over.as_slice(), &tight, &["--until", until]].concat();
        let (rows, summary) = sweep(folder.path(), &path, &arguments);
        let (full, by_kane) = sweep(folder.path(), &path, &[&arguments[..], &["--by", "kane"]].concat());
        assert_eq!(by_kane["formulation"], "kane");
        let is_reduced = summary["formulation"] == "reduced";
        reduced += usize::from(is_reduced);
        assert_eq!(is_reduced, summary["notes"].as_array().unwrap().is_empty(), "{scene}: {summary}");
        // Tolerances of 1e-12, in motions that multiply errors by up to a thousand.
        let difference = difference(&rows, &full);
        assert!(difference < 1e-8, "{scene} {over:?}: {difference:e}");
    }
    assert!(reduced >= 10, "{reduced} of these scenes run by reduced equations");
}

/// Goal: the columns of a table do not depend on what is compiled. Method: a pendulum whose full equations are
/// compiled, and a copy of its model, which is interpreted; lengths that vary are in no compiled reduced equations.
#[test]
fn columns_do_not_depend_on_the_equations_that_run() {
    let folder = tempfile::tempdir().unwrap();
    let model = std::fs::read_to_string(root().join("models/pendulum/model.toml")).unwrap();
    std::fs::write(folder.path().join("model.toml"), format!("# another text\n{model}")).unwrap();
    let scene = |name: &str, model: &Path| {
        let text = format!(
            "model = '{}'\nspan = [0, 1]\noutputs = [\"theta\", \"sin(theta)\"]\n[start]\ntheta = 1\nomega = 0\n\
             [integration]\nrtol = 1e-10\natol = 1e-12\n",
            model.display()
        );
        std::fs::write(folder.path().join(name), text).unwrap();
        folder.path().join(name)
    };
    let compiled = scene("compiled.toml", &root().join("models/pendulum/model.toml"));
    let own = scene("own.toml", &folder.path().join("model.toml"));
    let (rows, summary) = sweep(folder.path(), &compiled, &["--over", "l=1,2"]);
    assert_eq!((&summary["formulation"], &summary["compiled"]), (&"kane".into(), &true.into()), "{summary}");
    let (others, summary) = sweep(folder.path(), &own, &["--over", "l=1,2"]);
    assert_eq!((&summary["formulation"], &summary["compiled"]), (&"reduced".into(), &false.into()), "{summary}");
    let columns = |rows: &[Row]| rows[0].keys().cloned().collect::<std::collections::BTreeSet<String>>();
    assert_eq!(columns(&rows), columns(&others));
    assert!(columns(&rows).contains("change of energy T + V") && !columns(&rows).contains("omega"));
    assert!(difference(&rows, &others) < 1e-9);
}

/// Goal: a point at which the reduced equations have no value runs by full equations. Method: a spherical pendulum that
/// starts at its pole, where its momentum determines no speed, beside one that does not, against `simulate`.
#[test]
fn points_without_reduced_equations_run_by_full_equations() {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join("tests/data/repro/pole_start/s.toml");
    let (rows, summary) = sweep(folder.path(), &scene, &["--over", "theta=1,pi"]);
    assert_eq!(summary["formulation"], "reduced");
    for row in &rows {
        let set = format!("theta={}", row["over:theta"]);
        let run = tripos(&["simulate", scene.to_str().unwrap(), "--set", &set, "--json"]);
        let run: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        assert_eq!((row["stop"].as_str(), row["reason"].as_str()), ("end", ""));
        for name in ["phi", "theta", "uphi", "utheta"] {
            let (a, b): (f64, f64) = (row[name].parse().unwrap(), run["state"][name].as_f64().unwrap());
            assert!((a - b).abs() < 1e-11, "{set}: {name} = {a} and {b}");
        }
    }
}

/// Goal: quadrature and projection sweep too, and refuse what they cannot do before anything is written. Method: the
/// lean of the disk against steps, and requests that have no energy integral.
#[test]
fn quadrature_and_projection_sweep_reduced_equations() {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join("models/disk/scenes/lean.toml");
    let over = ["--over", "q2=0.1:1.2:4", "--until", "3"];
    let (steps, _) = sweep(folder.path(), &scene, &[&over[..], &["--rtol", "1e-13", "--atol", "1e-14"]].concat());
    for more in [&["--method", "quadrature"][..], &["--project", "energy", "--rtol", "1e-12", "--atol", "1e-13"]] {
        let (rows, summary) = sweep(folder.path(), &scene, &[&over[..], more].concat());
        assert_eq!(summary["formulation"], "reduced");
        let difference = difference(&rows, &steps);
        assert!(difference < 1e-9, "{more:?}: {difference:e}");
    }
    let refused = |scene: &str, more: &[&str]| {
        let path = root().join(format!("models/{scene}.toml"));
        let out = folder.path().join("refused.csv");
        let fixed = ["sweep", path.to_str().unwrap(), "--until", "1", "--out", out.to_str().unwrap()];
        let output = tripos(&[&fixed, more].concat());
        assert!(status(&output) == 2 && !out.exists(), "{}", stderr(&output));
        stderr(&output)
    };
    let text = refused("disk/scenes/lean", &["--over", "q2=1,2", "--method", "quadrature", "--by", "kane"]);
    assert!(text.contains("quadrature and projection need the scene's reduced equations"), "{text}");
    let text = refused("furuta/scenes/swing", &["--over", "theta2=1,2", "--method", "quadrature"]);
    assert!(text.contains("quadrature"), "{text}");
}
