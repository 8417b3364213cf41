//! The command as its users meet it: answers, exit statuses, messages.

use crate::support::{json, page, root, status, stderr, stdout, tripos, without_scripts};
use expect_test::expect;
use std::path::Path;

fn write(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Goal: the certified state at t = 1 s (reduction to one degree of freedom, extended precision).
/// 1e-8 is asked for at these tolerances; the three reach it with four digits to spare.
#[test]
fn each_formulation_reaches_the_certified_state() {
    for by in ["kane", "lagrange", "newton-euler"] {
        let scene = "models/disk/scenes/report.toml";
        let run = json(&tripos(&["simulate", scene, "--by", by, "--rtol", "1e-12", "--atol", "1e-12", "--json"]));
        assert_eq!(run["t"], 1.0, "exactly the end");
        assert_eq!(run["stop"], "end");
        assert_eq!(run["compiled"], true);
        for (name, certified) in [("q1", 0.091_668_485_077_693_79), ("q2", 1.486_657_519_320_656)] {
            let error = run["state"][name].as_f64().unwrap() - certified;
            assert!(error.abs() < 1e-8, "{by}: {name} is off by {error:e}");
        }
        assert_eq!(run["state"].as_object().unwrap().len(), 10, "all coordinates and all speeds");
    }
}

/// A model that is not compiled in runs by interpretation, to the same numbers.
#[test]
fn a_model_outside_the_workspace_is_interpreted() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(root().join("models/disk/model.toml")).unwrap();
    std::fs::create_dir(folder.path().join("scenes")).unwrap();
    write(folder.path(), "model.toml", &format!("# another text\n{text}"));
    let scene = std::fs::read_to_string(root().join("models/disk/scenes/report.toml")).unwrap();
    let scene = write(&folder.path().join("scenes"), "s.toml", &scene);
    let interpreted = json(&tripos(&["simulate", &scene, "--json", "--rtol", "1e-9", "--until", "0.5"]));
    let compiled =
        json(&tripos(&["simulate", "models/disk/scenes/report.toml", "--json", "--rtol", "1e-9", "--until", "0.5"]));
    assert_eq!((&interpreted["compiled"], &compiled["compiled"]), (&false.into(), &true.into()));
    assert_eq!(interpreted["t"], 0.5);
    for (name, value) in compiled["state"].as_object().unwrap() {
        let difference = value.as_f64().unwrap() - interpreted["state"][name].as_f64().unwrap();
        assert!(difference.abs() < 1e-10, "{name}: {difference:e}; the same steps up to rounding");
    }
}

/// The report's "semi-analytical" comparison: three formulations at one state, key by key.
#[test]
fn evaluate_gives_the_same_accelerations_by_each_formulation() {
    let folder = tempfile::tempdir().unwrap();
    let state = "[state]\nq1 = 0.1745\nq2 = 0.0349\nq3 = 0.7854\nq4 = 5\nq5 = 1\n\
                 \"q1'\" = 0.1\n\"q2'\" = 0.01\n\"q3'\" = 0.0203\n\"q4'\" = 0.4\n\"q5'\" = 0.1\n";
    let at = write(folder.path(), "state.toml", state);
    for by in ["kane", "lagrange", "newton-euler"] {
        let values = json(&tripos(&["evaluate", "models/disk", "--by", by, "--at", &at, "--json"]));
        // Case K19 of the reference data: an independent engine.
        for (name, reference) in [("u1'", -1.366_933_256_661_218_7), ("u5'", -1.344_662_914_460_576_8)] {
            let error = values["accelerations"][name].as_f64().unwrap() - reference;
            assert!(error.abs() < 1e-12, "{by}: {name} is off by {error:e}");
        }
        let order = values["unknowns"].as_array().unwrap().len();
        assert_eq!(order, if by == "newton-euler" { 6 } else { 5 });
        assert_eq!(values["mass_matrix"].as_array().unwrap().len(), order);
        assert_eq!(values["reactions"]["N"].is_number(), by == "newton-euler");
    }
}

#[test]
fn a_broken_model_is_answered_with_every_error_and_status_2() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(root().join("models/disk/model.toml")).unwrap();
    let text = text.replace("u1 = \"-q2'\"", "u1 = \"-q9'\"").replace("mass = \"M\"", "mas = \"M\"");
    let path = write(folder.path(), "model.toml", &text);
    let output = tripos(&["derive", &path]);
    assert_eq!(status(&output), 2);
    assert_eq!(stdout(&output), "");
    let message = stderr(&output).replace(&path, "model.toml");
    expect![[r#"
        error: unknown name `q9'`
          --> model.toml:18:8
           |
        18 | u1 = "-q9'"
           |        ^^^
           |
           = help: did you mean `q1'`?

        error: body `disk` has no `mass`
          --> model.toml:37:9
           |
        37 | [bodies.disk]
           |         ^^^^
           |
           = help: add `mass = …`

        error: unknown key `mas` in a body
          --> model.toml:40:1
           |
        40 | mas = "M"
           | ^^^
           |
           = help: did you mean `mass`?
    "#]]
    .assert_eq(&message);
}

#[test]
fn a_broken_scene_is_answered_with_every_error_and_status_2() {
    let folder = tempfile::tempdir().unwrap();
    let model = root().join("models/disk/model.toml");
    let scene = format!(
        "model = '{}'\nspan = [0, 0]\n[start]\nq1 = \"10 degrees\"\nq2 = nan\nq7 = 1\n[integration]\nmethd = \"ode45\"\nrtol = -1\n",
        model.display()
    );
    let path = write(folder.path(), "scene.toml", &scene);
    let output = tripos(&["simulate", &path]);
    assert_eq!(status(&output), 2);
    let message = stderr(&output).replace(&path, "scene.toml");
    expect![[r#"
        error: the span is empty
         --> scene.toml:2:8
          |
        2 | span = [0, 0]
          |        ^^^^^^
          |
          = help: let the last instant differ from the first

        error: an operator is missing here
         --> scene.toml:4:10
          |
        4 | q1 = "10 degrees"
          |          ^
          |
          = help: angles are in radians: in a scene or state write 90 degrees as `90*deg`, in a model as `90*pi/180`

        error: `q2` is `nan`, not a number
         --> scene.toml:5:6
          |
        5 | q2 = nan
          |      ^^^
          |
          = help: give a finite number

        error: the model has no coordinate or speed `q7`
         --> scene.toml:6:1
          |
        6 | q7 = 1
          | ^^
          |
          = help: did you mean `q1`?

        error: unknown key `methd` in `integration`
         --> scene.toml:8:1
          |
        8 | methd = "ode45"
          | ^^^^^
          |
          = help: did you mean `method`?

        error: `rtol` is negative
         --> scene.toml:9:8
          |
        9 | rtol = -1
          |        ^^
          |
          = help: let `rtol` be zero or above
    "#]]
    .assert_eq(&message);
}

/// A run into its domain's edge ends there: the disk falls flat from rest, exactly when theory says.
#[test]
fn the_flat_fall_ends_at_the_edge_of_the_domain() {
    let folder = tempfile::tempdir().unwrap();
    let model = root().join("models/disk/model.toml");
    let zeros = ["q1", "q3", "q4", "q5", "u1", "u2", "u3", "u4", "u5"].map(|n| format!("{n} = 0\n")).concat();
    let scene = format!(
        "model = '{}'\nspan = [0, 2]\n[start]\nq2 = 0.1\n{zeros}[integration]\nrtol = 1e-11\natol = 1e-12\n",
        model.display()
    );
    let path = write(folder.path(), "flat.toml", &scene);
    for by in ["kane", "lagrange", "newton-euler"] {
        let run = json(&tripos(&["simulate", &path, "--by", by, "--json"]));
        assert_eq!(run["stop"], "domain:upright (abs(q2) < pi/2)", "{by}");
        // Reduction to one degree of freedom, extended precision: t = 0.758966569575714 s, |q2'| = 3.951909 rad/s.
        let error = run["t"].as_f64().unwrap() - 0.758_966_569_575_714;
        assert!(error.abs() < 1e-9, "{by}: {error:e}");
        assert!((run["state"]["u1"].as_f64().unwrap() + 3.951_909).abs() < 1e-6, "{by}");
    }
}

#[test]
fn a_run_that_cannot_go_on_says_when_and_why_with_status_3() {
    let folder = tempfile::tempdir().unwrap();
    let model = root().join("models/disk/model.toml");
    let scene = std::fs::read_to_string(root().join("models/disk/scenes/report.toml")).unwrap();
    let scene =
        format!("model = '{}'\n{}", model.display(), scene.replace("rtol = 1e-3", "step_limit = 7\nrtol = 1e-3"));
    let path = write(folder.path(), "scene.toml", &scene);
    let csv = folder.path().join("out.csv");
    let output = tripos(&["simulate", &path, "--json", "--csv", csv.to_str().unwrap()]);
    assert_eq!(status(&output), 3);
    let run: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(run["stop"], "step-limit");
    assert!(stderr(&output).contains("after 7 steps"), "{}", stderr(&output));
    let rows = std::fs::read_to_string(csv).unwrap();
    assert!(rows.lines().count() > 7, "what it has is written");
    assert!(rows.starts_with("t,q1,q2,q3,q4,q5,u1,u2,u3,u4,u5,kinetic_energy,potential_energy\n"));
}

#[test]
fn an_unsupported_formulation_is_refused_with_the_reason() {
    let output = tripos(&["derive", "derive/tests/models/k06a.toml", "--by", "newton-euler"]);
    assert_eq!(status(&output), 2);
    assert!(stderr(&output).contains("`elbow` acts on a frame without a body"), "{}", stderr(&output));
    let output = tripos(&["derive", "models/disk", "--by", "kanes"]);
    assert_eq!(status(&output), 2);
    assert!(stderr(&output).contains("did you mean `kane`?"));
}

#[test]
fn output_that_cannot_be_written_is_an_error_not_a_panic() {
    let scene = "models/disk/scenes/report.toml";
    let output = tripos(&["simulate", scene, "--csv", "no/such/folder/x.csv"]);
    assert_eq!(status(&output), 2);
    assert!(stderr(&output).contains("cannot write `no/such/folder/x.csv`"));
    if Path::new("/dev/full").exists() {
        let output = tripos(&["simulate", scene, "--csv", "/dev/full"]);
        assert_eq!(status(&output), 2);
        assert!(stderr(&output).contains("cannot write"));
    }
    for bad in [["--rtol", "nan"], ["--atol", "-1"], ["--until", "0"], ["--until", "inf"], ["--method", "ode23"]] {
        let output = tripos(&["simulate", scene, bad[0], bad[1]]);
        assert_eq!(status(&output), 2, "{bad:?}");
        assert!(stderr(&output).contains("help:") || stderr(&output).contains("tip:") || bad[1] == "-1", "{bad:?}");
    }
}

#[test]
fn derive_prints_the_count_and_the_same_equations_in_every_format() {
    let text = stdout(&tripos(&["derive", "models/disk", "--by", "kane"]));
    assert!(text.contains(
        "6 configuration variables, 1 holonomic constraint, 5 generalized coordinates, 0 nonholonomic constraints, 5 generalized speeds"
    ));
    let value = json(&tripos(&["derive", "models/disk", "--by", "kane", "--format", "json"]));
    assert_eq!(value["formulations"][0]["mass_matrix"][0][0], "5*M*R^2/4");
    assert!(text.contains("5*M*R^2/4*u1'"), "{text}");
    assert!(stdout(&tripos(&["derive", "models/disk", "--format", "latex"])).contains("\\begin{bmatrix}"));
    assert!(stdout(&tripos(&["derive", "models/disk", "--format", "mathml"])).contains("<math"));
}

#[test]
fn the_report_page_is_one_file_with_equations_and_figures() {
    for (model, figures) in [
        ("models/disk", 22),
        ("models/chaotic_pendulum", 5),
        ("models/cart_pendulum_3", 5),
        ("models/heavy_top", 12),
        ("models/pendulum", 8),
        ("models/spherical_pendulum", 9),
        ("models/free_body", 9),
        ("models/floating_chain", 9),
        ("models/euler_top", 9),
    ] {
        let (page, said) = page(model);
        assert!(said.trim_end().ends_with("index.html"), "the page's path comes last");
        assert_eq!(page.matches("<svg").count(), figures, "{model}");
        let shown = without_scripts(&page);
        assert!(page.contains("<math") && !page.contains("src=\"http") && !shown.contains("NaN"), "{model}");
    }
}

/// A run whose conserved energy blows up says so, however loose its tolerances; a tight one has nothing to say.
#[test]
fn a_run_that_cannot_be_trusted_says_so() {
    let scene = "models/disk/scenes/report-10s.toml";
    for (rtol, warned) in [("1e-1", true), ("1e-3", true), ("1e-11", false)] {
        let run = json(&tripos(&["simulate", scene, "--rtol", rtol, "--atol", "1e-11", "--json"]));
        let warnings = run["warnings"].as_array().unwrap();
        assert_eq!(!warnings.is_empty(), warned, "rtol {rtol}: {warnings:?}, drift {}", run["drift"]);
    }
}

/// The JSON that other programs read: three proved pairs, six integrals, and where all of it fails.
#[test]
fn prove_states_its_verdicts_as_json() {
    let output = tripos(&["prove", "models/disk", "--json"]);
    assert_eq!(status(&output), 0);
    let proof = json(&output);
    assert_eq!(proof["equivalent"], true);
    let pairs = proof["pairs"].as_array().unwrap();
    assert_eq!(pairs.len(), 3);
    assert!(pairs.iter().all(|p| p["verdict"] == "equal" && p["engine"] == "normal-form"), "{pairs:?}");
    assert!(pairs[0]["map"].as_str().unwrap().contains("Wᵀ"));
    let integrals = proof["integrals"].as_array().unwrap();
    assert!(integrals.len() >= 5 && integrals.iter().all(|i| i["verdict"] == "proved"), "{integrals:?}");
    assert_eq!(proof["singular_where"], serde_json::json!(["cos(q2)"]));
}

#[test]
fn diff_judges_a_report_and_exits_with_1_where_it_is_wrong() {
    let output = tripos(&["diff", "models/disk/model.toml", "models/disk/publication.toml", "--json"]);
    assert_eq!(status(&output), 1);
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(value["summary"]["undecided"], 0);
    let equations = value["equations"].as_array().unwrap();
    let wrong = equations.iter().find(|e| e["id"] == "newton-euler-final-row5").unwrap();
    assert_eq!(wrong["verdict"], "different");
    assert_eq!(wrong["difference"], "u1*(u2*tan(q2) - u3)");
    assert!(wrong["witness"]["left"].is_number());
    let consequences = value["consequences"].as_array().unwrap();
    assert!(consequences.iter().any(|c| c["system"] == "kane-final" && c["conserved"] == false));
}

/// The printed Newton–Euler system and the program that solves it give one motion, which is not the derived one.
#[test]
fn printed_equations_run_as_printed() {
    let scene = "models/disk/scenes/report.toml";
    let q1 = |by: &str| {
        let run = json(&tripos(&["simulate", scene, "--by", by, "--rtol", "1e-10", "--atol", "1e-10", "--json"]));
        assert_eq!(run["formulation"], by);
        run["state"]["q1"].as_f64().unwrap()
    };
    let (system, program, derived) = (q1("printed:newton-euler-final"), q1("printed:listing-5.6"), q1("newton-euler"));
    assert!((system - program).abs() < 1e-6, "{system} {program}");
    assert!((system - derived).abs() > 0.1, "{system} {derived}");
    let output = tripos(&["simulate", scene, "--by", "printed:kane-fina"]);
    assert_eq!(status(&output), 2);
    assert!(stderr(&output).contains("did you mean `printed:kane-final`?"), "{}", stderr(&output));
}
