//! Arguments that people mistake: values for one run, files of another kind, names of other formats.

use crate::support::tripos_in;
use std::path::Path;

/// The working folder that `tripos new crane` makes.
fn crane(folder: &Path) {
    assert_eq!(tripos_in(folder, &["new", "crane"]).0, 0);
}

/// Runs a command that is refused, and returns its message.
fn refused(folder: &Path, arguments: &[&str]) -> String {
    let (status, _, said) = tripos_in(folder, arguments);
    assert_eq!(status, 2, "{arguments:?}: {said}");
    said
}

/// Goal: `--set` is the scene with another value. Method: the cart twice as heavy, on the command line and in the
/// scene, to the last bit; names and forms that mean nothing are refused.
#[test]
fn a_value_that_is_set_is_that_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    crane(place);
    let scene = place.join("crane/scenes/first.toml");
    let text = std::fs::read_to_string(&scene).unwrap();
    std::fs::write(place.join("crane/scenes/heavy.toml"), format!("{text}\n[parameters]\nM = 4\n")).unwrap();
    let end = |arguments: &[&str]| {
        let (status, out, said) = tripos_in(place, arguments);
        assert_eq!(status, 0, "{said}");
        let run: serde_json::Value = serde_json::from_str(&out).unwrap();
        (run["state"].clone(), said)
    };
    let (set, said) = end(&["simulate", "crane/scenes/first.toml", "--set", "M=4", "--json"]);
    assert!(said.contains("note: M = 4, not the value of the scene"), "{said}");
    assert_eq!(set, end(&["simulate", "crane/scenes/heavy.toml", "--json"]).0);
    assert_ne!(set, end(&["simulate", "crane/scenes/first.toml", "--json"]).0);
    // Other commands take it in the same way.
    let reduced = |arguments: &[&str]| {
        let (status, out, said) = tripos_in(place, arguments);
        assert_eq!(status, 0, "{said}");
        let scene: serde_json::Value = serde_json::from_str(&out).unwrap();
        (scene["equations"].clone(), scene["constants"].clone())
    };
    let set = reduced(&["scene", "crane/scenes/first.toml", "--set", "M=4", "--json"]);
    assert_eq!(set, reduced(&["scene", "crane/scenes/heavy.toml", "--json"]));
    assert_ne!(set, reduced(&["scene", "crane/scenes/first.toml", "--json"]));
    for command in ["chart", "stability"] {
        let said = refused(place, &[command, "crane/scenes/first.toml", "--quick", "--set", "M=-1"]);
        assert!(said.contains("`M` is stated to be positive but is -1"), "{command}: {said}");
    }
    for (value, expected) in [
        ("mass=4", "the scene has no parameter or start value `mass`"),
        ("M", "`--set M` gives no value"),
        ("M=1,2", "`--set` gives 2 values where a run has one"),
        ("M=-1", "`M` is stated to be positive but is -1"),
    ] {
        let said = refused(place, &["simulate", "crane/scenes/first.toml", "--set", value]);
        assert!(said.contains(expected), "{value}: {said}");
    }
}

/// Goal: a model, a scene and a folder in one another's place are told apart, and the file that may be meant is named.
#[test]
fn files_of_another_kind_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    crane(place);
    std::fs::write(place.join("crane/scenes/lost.toml"), "model = \"nowhere.toml\"\nspan = [0, 1]\n[start]\n").unwrap();
    for (arguments, expected) in [
        (&["prove", "crane/scenes/first.toml"][..], &["is a scene, not a model", "give its model, `crane/"][..]),
        (&["simulate", "crane/model.toml"], &["is a model, not a scene", "crane/scenes/first.toml"]),
        (&["simulate", "crane"], &["`crane` is a folder, not a scene", "crane/scenes/first.toml"]),
        (&["simulate", "crane/scenes/frist.toml"], &["there is no scene at", "did you mean `first.toml`?"]),
        (&["simulate", "nowhere/first.toml"], &["there is no scene at", "there is no folder `nowhere` either"]),
        (&["simulate", "crane/scenes/lost.toml"], &["names a model that does not exist", "nowhere.toml"]),
        (&["new", "arm", "--like", "crane/scenes/first.toml"], &["is no model file"]),
        (
            &["sweep", "crane/scenes/first.toml", "--over", "M=1,2", "--out", "grid.parquet"],
            &["`grid.parquet` is a table in columns, and this program writes CSV", "tripos-cli/tables"],
        ),
        (
            &["simulate", "crane/scenes/first.toml", "--csv", "run.xlsx"],
            &["`run.xlsx` ends in `.xlsx`, and this command writes CSV"],
        ),
    ] {
        let said = refused(place, arguments);
        assert!(expected.iter().all(|part| said.contains(part)), "{arguments:?}: {said}");
    }
    assert!(!place.join("arm").exists() && !place.join("grid.parquet").exists());
}

/// Goal: an axis names the unit of its quantity. Method: an angle, the angle in degrees by two spellings, its sine, its
/// rate and a force; the labels of the figure.
#[test]
fn axes_name_the_units_of_formulas() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    crane(place);
    for (what, unit) in [
        ("q_pivot", "rad"),
        ("q_pivot*180/pi", "°"),
        ("q_pivot/deg", "°"),
        ("sin(q_pivot)", "1"),
        ("q_pivot'", "rad/s"),
        ("u_track'", "m/s²"),
        ("q_track/l", "1"),
        ("u_track/l", "1/s"),
        ("M*g", "N"),
    ] {
        let arguments = ["plot", "crane/scenes/first.toml", "--what", what, "--out", "figure.svg"];
        let (status, _, said) = tripos_in(place, &arguments);
        assert_eq!(status, 0, "{what}: {said}");
        let figure = std::fs::read_to_string(place.join("figure.svg")).unwrap();
        let title = figure.split("</title>").next().unwrap();
        assert!(title.contains(&format!(" [{unit}] against t [s]")), "{what}: {title}");
    }
}
