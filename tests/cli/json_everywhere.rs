//! `--json` of every command: one JSON object on standard output, for an answer and for a failure.

use crate::support::{root, tripos_in};
use serde_json::Value;
use std::path::Path;

/// Runs a command with `--json`, and returns its status and the object that it printed.
fn object(folder: &Path, arguments: &[&str]) -> (i32, Value) {
    let arguments = [arguments, &["--json"]].concat();
    let (status, out, said) = tripos_in(folder, &arguments);
    let value: Value = serde_json::from_str(&out).unwrap_or_else(|e| panic!("{arguments:?}: {e}\n{out}{said}"));
    assert_eq!(value["schema"], 1, "{arguments:?}");
    (status, value)
}

/// Goal: a program reads the answer of every command that works on a model or a scene. Method: the cart of `tripos
/// new`; each command that writes files names them, and they are there.
#[test]
fn every_command_answers_in_json() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    assert_eq!(tripos_in(place, &["new", "crane"]).0, 0);
    let scene = "crane/scenes/first.toml";
    for (arguments, key) in [
        (&["derive", "crane", "--by", "kane"][..], "formulations"),
        (&["check", "crane"], "coordinates"),
        (&["prove", "crane"], "pairs"),
        (&["identify", "crane"], "base"),
        (&["excite", "crane", "--starts", "1", "--limit", "q_track=1", "--limit", "q_pivot=1"], "log_determinant"),
        (&["scene", scene], "model"),
        (&["simulate", scene], "state"),
        (&["sketch", scene, "--out", "s.svg"], "files"),
        (&["view", scene, "--out", "v.html"], "files"),
        (&["plot", scene, "--out", "p.svg"], "figure"),
        (&["emit", "crane", "--out", "code"], "files"),
        (&["emit", "crane", "--language", "js", "--out", "js"], "files"),
        (&["page", "crane", "--out", "page"], "files"),
        (&["stability", scene, "--quick", "--out", "limits"], "statements"),
    ] {
        let (status, value) = object(place, arguments);
        assert_eq!(status, 0, "{arguments:?}: {value}");
        assert!(value.get(key).is_some(), "{arguments:?}: {value}");
        for file in value["files"].as_array().into_iter().flatten() {
            let file = file.as_str().map_or_else(
                || format!("{}/{}", value["folder"].as_str().unwrap(), file["file"].as_str().unwrap()),
                str::to_owned,
            );
            assert!(place.join(&file).is_file(), "{arguments:?}: {file}");
        }
    }
    let (_, plot) = object(place, &["plot", scene, "--out", "p.svg"]);
    assert_eq!((plot["figure"].as_str(), plot["data"].as_str()), (Some("p.svg"), Some("p.csv")));
    assert!(plot["runs"][0]["equations"].is_string() && plot["panels"].as_array().is_some_and(|list| !list.is_empty()));
}

/// Goal: a failure is JSON, too. Method: each command with a file that is not there.
#[test]
fn every_command_fails_in_json() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [
        &["derive", "nothing"][..],
        &["page", "nothing"],
        &["plot", "nothing.toml"],
        &["view", "nothing.toml"],
        &["sketch", "nothing"],
        &["emit", "nothing", "--out", "code"],
        &["chart", "nothing.toml"],
        &["stability", "nothing.toml"],
        &["regenerate", "--check"],
    ] {
        let (status, value) = object(folder.path(), arguments);
        assert_eq!(status, 2, "{arguments:?}");
        assert_eq!(value["exit_status"], 2, "{arguments:?}: {value}");
        assert!(value["error"]["message"].is_string() && value["error"]["help"].is_string(), "{arguments:?}: {value}");
    }
}

/// Goal: `--form` chooses the form of the equations, and one that does not exist is refused. Method: the gyroscope in
/// gimbals, which is written out by default.
#[test]
fn the_form_of_equations_is_chosen() {
    let named = |arguments: &[&str]| {
        let all = [&["derive", "models/gimbals", "--by", "kane", "--json"], arguments].concat();
        let (status, out, said) = tripos_in(&root(), &all);
        assert_eq!(status, 0, "{said}");
        let value: Value = serde_json::from_str(&out).unwrap();
        value["formulations"][0]["named"].as_array().unwrap().len()
    };
    assert_eq!((named(&[]), named(&["--form", "closed"])), (0, 0));
    assert!(named(&["--form", "steps"]) > 30);
    assert_eq!(tripos_in(&root(), &["derive", "models/gimbals", "--form", "short"]).0, 2);
    let (_, matrix, _) = tripos_in(&root(), &["derive", "models/gimbals", "--by", "kane"]);
    assert!(matrix.contains("(Iz + sin(theta)^2*(Ay + B) + cos(theta)^2*(Az + C))*u_psi'"), "{matrix}");
}
