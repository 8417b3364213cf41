//! `tripos grade`: marks by root mistakes, feedback by levels, rubrics, and the adapters for systems of teaching.

use crate::left_out::is_left_out;
use crate::support::{SLIDER, root, tripos_in};
use serde_json::Value;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// Kinetic energy, potential energy and equation of motion of the mass on a spring, in this order.
fn homework(entries: [&str; 3]) -> String {
    let [t, l, motion] = entries;
    format!(
        "[[equation]]\nid = \"T\"\nsection = \"1\"\nquantity = \"T\"\nprinted = \"{t}\"\n[[equation]]\nid = \"energy\"\nsection = \"1\"\n\
         quantity = \"energy\"\nprinted = \"{l}\"\n[[equation]]\nid = \"motion\"\nsection = \"2\"\nprinted = \"{motion}\"\n"
    )
}

const RIGHT: [&str; 3] = ["m*x'^2/2", "m*x'^2/2 + k*x^2/2", "m*x'' + k*x = 0"];
/// T is a factor 2 too large; the energy follows from it.
const FOLLOWED: [&str; 3] = ["m*x'^2", "m*x'^2 + k*x^2/2", "m*x'' = k*x"];

fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    std::fs::create_dir(folder.path().join("hand-ins")).unwrap();
    for (name, text) in [
        ("model.toml", SLIDER.to_owned()),
        ("hand-ins/ada.toml", homework(RIGHT)),
        ("hand-ins/ben.toml", homework(FOLLOWED)),
        ("hand-ins/spoilt.toml", homework(["m*y'^2/2", "0", "0 = 0"])),
        ("rubric.toml", "default = 2\nrequired = [\"T\", \"V\"]\nlevel = \"term\"\n[points]\nmotion = 3\n".to_owned()),
    ] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn json(folder: &Path, arguments: &[&str]) -> Value {
    let (_, out, err) = tripos_in(folder, &[&["grade", "model.toml"], arguments, &["--json"]].concat());
    serde_json::from_str(&out).unwrap_or_else(|_| panic!("{out}{err}"))
}

#[test]
fn a_consequence_costs_nothing_and_a_hint_names_no_term() {
    let folder = folder();
    let (status, out, err) = tripos_in(folder.path(), &["grade", "model.toml", "hand-ins/ben.toml"]);
    assert_eq!((status, err.as_str()), (1, ""));
    assert_eq!(
        out,
        "ben: 1 of 3 points\n  WRONG    T: look for a number\n  follows  energy: from T, which is wrong\n  WRONG    motion: look for a sign\n\n"
    );
    let (status, out, _) = tripos_in(folder.path(), &["grade", "model.toml", "hand-ins/ada.toml"]);
    assert_eq!((status, out.lines().next()), (0, Some("ada: 3 of 3 points")));
}

#[test]
fn a_rubric_gives_points_and_names_what_is_lacking() {
    let folder = folder();
    let found = json(folder.path(), &["hand-ins/ben.toml", "--rubric", "rubric.toml"]);
    let one = &found["submissions"][0];
    assert_eq!(
        (&one["points"], &one["of"], &found["level"]),
        (&Value::from(2.0), &Value::from(9.0), &Value::from("term"))
    );
    let outcomes: Vec<&str> =
        one["entries"].as_array().unwrap().iter().map(|e| e["outcome"].as_str().unwrap()).collect();
    assert_eq!(outcomes, ["wrong", "follows", "wrong", "lacking"]);
    let level = |level: &str| {
        let found = json(folder.path(), &["hand-ins/ben.toml", "--rubric", "rubric.toml", "--level", level]);
        found["submissions"][0]["entries"][2]["feedback"].as_str().unwrap().to_owned()
    };
    assert_eq!(level("place"), "look for a sign in the right-hand side");
    assert!(level("term").contains("k*x should be -k*x"), "{}", level("term"));
}

#[test]
fn a_folder_of_submissions_tells_who_made_which_mistake() {
    let folder = folder();
    let (status, out, _) = tripos_in(folder.path(), &["grade", "model.toml", "hand-ins", "--out", "marks.html"]);
    assert_eq!(status, 1);
    assert!(out.contains("spoilt: not read\nerror: unknown name `y'`"), "{out}");
    assert!(out.contains("Who made which mistake\n  T: it is off by the factor 2\n    ben\n"), "{out}");
    let page = std::fs::read_to_string(folder.path().join("marks.html")).unwrap();
    assert!(page.contains("<td>ben</td><td class=\"n\">1 of 3</td>") && !page.contains("<script"), "{page}");
}

#[test]
fn wrong_requests_say_what_is_wrong() {
    let folder = folder();
    for (arguments, expected) in [
        (&["hand-ins", "--level", "all"][..], "there is no level `all`"),
        (&["hand-ins", "--format", "gradescope"], "Gradescope runs the grader once"),
        (&["hand-ins", "--rubric", "model.toml"], "unknown key `name` in a rubric"),
        (&["nobody.toml"], "nobody.toml"),
    ] {
        let (status, out, err) = tripos_in(folder.path(), &[&["grade", "model.toml"], arguments].concat());
        assert!(status >= 1 && format!("{out}{err}").contains(expected), "{arguments:?}: {out}{err}");
    }
    std::fs::create_dir(folder.path().join("nothing")).unwrap();
    let (status, _, err) = tripos_in(folder.path(), &["grade", "model.toml", "nothing"]);
    assert!(status == 2 && err.contains("has no submission"), "{err}");
    let large = format!("# {}\n", "x".repeat(1_000_001));
    std::fs::write(folder.path().join("large.toml"), large).unwrap();
    let (_, out, _) = tripos_in(folder.path(), &["grade", "model.toml", "large.toml"]);
    assert!(out.contains("more than 1000000 bytes"), "{out}");
}

/// Goal: the adapters do what their pages promise. Method: each is run as its system would run it.
#[test]
fn the_adapters_give_the_marks() {
    let python = std::env::var_os("TRIPOS_PYTHON").filter(|p| !p.is_empty()).unwrap_or_else(|| "python3".into());
    let is_found = Command::new(&python).arg("--version").output().is_ok();
    if is_left_out("python", is_found, "the adapters are Python") {
        return;
    }
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    for name in ["tripos_grade.py", "prairielearn_server.py", "check_submission.py", "run_autograder"] {
        std::fs::copy(root().join("docs/grading").join(name), path(name)).unwrap();
    }
    let run = |script: &str| {
        let output = Command::new(&python)
            .args(["-c", script])
            .current_dir(folder.path())
            .env("TRIPOS", env!("CARGO_BIN_EXE_tripos"))
            .output()
            .unwrap();
        (
            output.status.success(),
            String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr),
        )
    };
    let question = "import json, prairielearn_server as server\n\
                    data = dict(submitted_answers={'equations': open('hand-ins/ben.toml').read()}, format_errors={}, partial_scores={}, feedback={})\n\
                    server.grade(data)\nprint(json.dumps(data))";
    std::fs::rename(path("rubric.toml"), path("other.toml")).unwrap();
    let (_, out) = run(question);
    let data: Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{out}"));
    assert!((data["score"].as_f64().unwrap() - 1.0 / 3.0).abs() < 1e-12, "{data}");
    assert!(data["feedback"]["equations"].as_str().unwrap().contains("motion: look for a sign"), "{data}");
    assert!(run("from check_submission import check; check('hand-ins/ada.toml')").0);
    let (is_right, out) = run("from check_submission import check; check('hand-ins/ben.toml')");
    assert!(!is_right && out.contains("motion: look for a sign"), "{out}");
    // The folders of Gradescope.
    for name in ["source", "submission"] {
        std::fs::create_dir(path(name)).unwrap();
    }
    std::fs::copy(path("model.toml"), path("source/model.toml")).unwrap();
    std::fs::copy(path("hand-ins/ben.toml"), path("submission/ben.toml")).unwrap();
    let done = Command::new("bash")
        .arg(path("run_autograder"))
        .env("AUTOGRADER", folder.path())
        .env("TRIPOS", env!("CARGO_BIN_EXE_tripos"))
        .status()
        .unwrap();
    assert!(done.success());
    let text = std::fs::read_to_string(path("results/results.json")).unwrap();
    let results: Value = serde_json::from_str(&text).unwrap_or_else(|_| panic!("{text}"));
    let tests = results["tests"].as_array().unwrap();
    assert_eq!((&results["score"], tests.len()), (&Value::from(1.0), 3));
    assert_eq!((&tests[1]["status"], &tests[2]["status"]), (&Value::from("passed"), &Value::from("failed")));
}
