//! `tripos fmu`: scenes as mock-up units, checked and run by `FMPy`.

use crate::left_out::is_left_out;
use crate::support::{root, stderr, tripos_in};
use crate::sympy;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Scenes whose motion comes so near to a singular surface that the steps of an importing tool fail there.
const NEAR_SINGULAR: [&str; 4] = ["disk/lean", "disk/near-flat", "disk/report-10s", "disk/report-tight"];
/// A scene in which the independent speeds of the model fail on the way; a unit ends the simulation there.
const ENDS: [&str; 2] = ["window_linkage/upright", "disk/flat-fall"];

fn has_compiler() -> bool {
    Command::new("cc").arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Scenes of the library, as `model/scene`.
fn scenes() -> Vec<(String, PathBuf)> {
    let mut list = Vec::new();
    for model in std::fs::read_dir(root().join("models")).unwrap() {
        let model = model.unwrap();
        let Ok(entries) = std::fs::read_dir(model.path().join("scenes")) else { continue };
        for scene in
            entries.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|e| e == "toml"))
        {
            let name = format!("{}/{}", model.file_name().display(), scene.file_stem().unwrap().display());
            list.push((name, scene));
        }
    }
    list.sort();
    assert!(list.len() > 40, "the library has scenes: {}", list.len());
    list
}

/// The unit of a scene, with what the command says of it and the end of the run by `simulate`.
fn entry(name: &str, scene: &Path, fmi: &str, folder: &Path) -> Value {
    let unit = folder.join(format!("{}_{fmi}.fmu", name.replace('/', "_")));
    let arguments = ["fmu", scene.to_str().unwrap(), "--out", unit.to_str().unwrap(), "--fmi", fmi, "--json"];
    let (status, said, err) = tripos_in(&root(), &arguments);
    assert_eq!(status, 0, "{name}: {err}");
    let said: Value = serde_json::from_str(&said).unwrap();
    let model = scene.parent().and_then(Path::parent).unwrap();
    let stem = model.file_name().unwrap().to_str().unwrap();
    let python = folder.join("constraints");
    let arguments = ["emit", model.to_str().unwrap(), "--out", python.to_str().unwrap(), "--language", "python"];
    let kane = ["--formulation", "kane", "--functions", "constraints"];
    // A model without constraints has no such function; where the unit ends early, it cannot be run coarsely.
    let has_constraints = !ENDS.contains(&name) && tripos_in(&root(), &[&arguments[..], &kane].concat()).0 == 0;
    let constraints = has_constraints.then(|| json!({ "folder": python, "module": format!("{stem}_kane") }));
    let (_, run, err) = tripos_in(&root(), &["simulate", scene.to_str().unwrap(), "--json"]);
    let run: Value = serde_json::from_str(&run).unwrap_or_else(|error| panic!("{name}: {error} {err}"));
    json!({
        "name": name,
        "unit": unit,
        "fmi": said["fmi"],
        "slopes": said["directional_derivatives"],
        "t": run["t"],
        "state": run["state"],
        "digits": run["digits"],
        "constraints": constraints,
    })
}

/// Goal: any tool imports the units, and their runs are those of `simulate`. Method: `FMPy` validates the unit of every
/// scene of the library, runs it by co-simulation and model exchange, compares directional derivatives with
/// differences and with adjoint ones, and repeats a run from a stored state.
#[test]
fn units_of_the_library_are_valid_and_run_as_simulate_does() {
    if sympy::is_left_out("FMPy") || is_left_out("gcc", has_compiler(), "there is no C compiler") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let list: Vec<Value> = ["3", "2"]
        .iter()
        .flat_map(|fmi| scenes().into_iter().map(move |(name, scene)| (fmi, name, scene)))
        .map(|(fmi, name, scene)| entry(&name, &scene, fmi, folder.path()))
        .collect();
    let (asked, answers) = (folder.path().join("list.json"), folder.path().join("answers.json"));
    std::fs::write(&asked, Value::from(list.clone()).to_string()).unwrap();
    let python =
        sympy::python_with(&root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy");
    let output =
        Command::new(python).arg(root().join("tests/languages/units.py")).args([&asked, &answers]).output().unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    let answers: Vec<Value> = serde_json::from_slice(&std::fs::read(answers).unwrap()).unwrap();
    let (mut slopes, mut runs, mut linkages) = (0, 0, 0);
    for (entry, answer) in list.iter().zip(&answers) {
        let name = entry["name"].as_str().unwrap();
        if NEAR_SINGULAR.contains(&name) {
            continue;
        }
        assert_eq!(answer["problems"], json!([]), "{name}: {answer}");
        let at_most = |key: &str, bound: f64| {
            let value = answer[key].as_f64();
            assert!(value.is_some_and(|value| value <= bound), "{name}: {key} {value:?} is above {bound:e}");
        };
        if ENDS.contains(&name) {
            let [end, first, second] =
                [&entry["t"], &answer["ended"], &answer["ended_exchange"]].map(|t| t.as_f64().unwrap());
            assert!(first < end && (first - second).abs() < 0.02 * end, "{name}: {first} s and {second} s of {end} s");
        } else {
            // A unit has the tolerance of its scene; the digits of the run tell what that is worth.
            let digits = entry["digits"].as_f64().unwrap();
            at_most("cosimulation", (20.0 * 10.0_f64.powf(-digits)).max(1e-9));
            at_most("exchange", (1e3 * 10.0_f64.powf(-digits)).max(1e-3));
            runs += 1;
            if entry["constraints"] != Value::Null {
                at_most("open", 1e-9);
                // Between two corrections the constraints drift by a little more than what asks for one.
                at_most("open_exchange", 1e-8);
                linkages += 1;
            }
        }
        if entry["fmi"] == json!("2.0") {
            continue;
        }
        at_most("restored", 0.0);
        if entry["slopes"] == json!(true) {
            at_most("slopes", 1e-5);
            at_most("transposed", 1e-12);
            slopes += 1;
        }
    }
    assert!(runs > 60 && slopes > 28 && linkages > 10, "{runs} runs, {slopes} units with slopes, {linkages} linkages");
}

/// Equal scenes give equal bytes of sources and description; a parameter may be set; nothing is half-written.
#[test]
fn units_are_described_and_refused_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join("models/furuta/scenes/swing.toml");
    let unit = |name: &str, more: &[&str]| {
        let out = folder.path().join(name);
        let arguments = ["fmu", scene.to_str().unwrap(), "--out", out.to_str().unwrap(), "--only-sources"];
        let result = tripos_in(&root(), &[&arguments[..], more].concat());
        (result, std::fs::read(out).unwrap_or_default())
    };
    let ((status, said, err), first) = unit("a.fmu", &[]);
    assert!(status == 0 && said.contains("a.fmu"), "{err}");
    let (_, second) = unit("b.fmu", &[]);
    assert_eq!(first, second, "equal scenes give equal bytes");
    let ((status, _, err), set) = unit("c.fmu", &["--set", "m2=0.1"]);
    assert!(status == 0 && set != first, "{err}");
    let text = String::from_utf8_lossy(&first);
    for part in [
        "fmiVersion=\"3.0\"",
        "<Float64 name=\"der(u_theta1)\"",
        "<BaseUnit m=\"2\" kg=\"1\"/>",
        "providesAdjointDerivatives=\"true\"",
        // The rate of theta1 is u_theta1 alone.
        "<ContinuousStateDerivative valueReference=\"16\" dependencies=\"14\"/>",
        "sources/buildDescription.xml",
    ] {
        assert!(text.contains(part), "{part}");
    }
    let ((status, _, err), second) = unit("e.fmu", &["--fmi", "2"]);
    let second = String::from_utf8_lossy(&second);
    assert!(status == 0 && second.contains("numberOfEventIndicators=\"0\""), "{err}");
    assert!(second.contains("<Unknown index=\"17\" dependencies=\"15\"/>"), "{second}");
    let ((status, said, err), bytes) = unit("f.fmu", &["--fmi", "1"]);
    assert!(status == 2 && said.is_empty() && bytes.is_empty() && err.contains("no units by FMI 1"), "{err}");
    let ((status, said, err), bytes) = unit("a.zip", &[]);
    assert!(status == 2 && said.is_empty() && bytes.is_empty(), "{err}");
    assert!(err.contains("does not end with .fmu") && err.contains("help: "), "{err}");
    let impacts = folder.path().join("impacts.toml");
    let text = std::fs::read_to_string(&scene).unwrap();
    std::fs::write(&impacts, text.replace("[start]", "[impacts.floor]\n[start]")).unwrap();
    let out = folder.path().join("d.fmu");
    let (status, _, err) = tripos_in(&root(), &["fmu", impacts.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert!(status == 2 && !out.exists() && err.contains("help: "), "{err}");
}

/// Goal: units serve as parts of a larger system. Method: the example of a cart and its controller, stepped together by
/// `FMPy`, against the exact motion of the linear system; the error halves with the step.
#[test]
fn two_units_move_together_as_one_system() {
    if sympy::is_left_out("two units") || is_left_out("gcc", has_compiler(), "there is no C compiler") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let example = root().join("examples/two_units");
    let units = ["cart/scenes/released.toml", "controller/scenes/at_rest.toml"].map(|scene| {
        let scene = example.join(scene);
        let unit = folder.path().join(scene.file_stem().unwrap()).with_extension("fmu");
        let arguments = ["fmu", scene.to_str().unwrap(), "--out", unit.to_str().unwrap()];
        let (status, _, err) = tripos_in(&root(), &arguments);
        assert_eq!(status, 0, "{err}");
        unit
    });
    let python =
        sympy::python_with(&root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy");
    let output = Command::new(python).arg(example.join("couple.py")).args(units).output().unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
}
