//! Loops beside a URDF file: `tripos new --from robot.urdf --loops loops.toml`.

use crate::robots::{assert_reference_values, description, model_in, numbers, without};
use crate::support::tripos_in;
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

/// Robot of these tests: a leg with a four-bar linkage, as a tree.
const STEM: &str = "leg_fourbar_tree";

/// Model of the leg with one of its files of loops, in a folder.
fn leg_in(folder: &Path, file: &str) -> String {
    std::fs::write(folder.join(file), description(file)).unwrap();
    model_in(folder, "leg.urdf", &description(&format!("{STEM}.urdf")), &["--loops", file, "--as-written"])
}

/// Closed state of a loops file, with the accelerations there, by Lagrange's multipliers
/// (tests/data/robots/reference.py).
fn reference(file: &str) -> Value {
    serde_json::from_str::<Value>(&description(&format!("{STEM}.loops.json"))).unwrap()["files"][file].clone()
}

/// Equations of a model in a folder at a closed state of the reference.
fn equations(folder: &Path, model: &str, state: &Value) -> Value {
    let mut text = "[state]\n".to_owned();
    for (name, value) in state["coordinates"].as_object().unwrap() {
        let _ = writeln!(text, "{name} = {value}");
    }
    for (name, value) in state["rates"].as_object().unwrap() {
        let _ = writeln!(text, "\"{name}'\" = {value}");
    }
    std::fs::write(folder.join("state.toml"), text).unwrap();
    let (status, out, err) = tripos_in(folder, &["evaluate", model, "--by", "kane", "--at", "state.toml", "--json"]);
    assert_eq!(status, 0, "{out}{err}");
    serde_json::from_str(&out).unwrap()
}

/// Goal: each kind of loop and a coupling have exact equations. Method: the accelerations at a closed state by
/// Lagrange's multipliers, with Pinocchio's mass matrix, bias and Jacobians. The hinge has an axis that is oblique in
/// the axes of the connection.
#[test]
fn loops_beside_a_urdf_file_have_the_accelerations_of_multipliers() {
    for kind in ["connect", "hinge", "weld"] {
        let folder = tempfile::tempdir().unwrap();
        let file = format!("{STEM}.{kind}.toml");
        let model = leg_in(folder.path(), &file);
        assert!(model.starts_with(&format!("# Made from leg.urdf (URDF) with the loops of {file} by")), "{model}");
        let state = reference(&file);
        let own = equations(folder.path(), "robot/model.toml", &state);
        let found = own["accelerations"].as_object().unwrap();
        assert_eq!(found.len(), if kind == "weld" { 5 } else { 6 });
        for (name, value) in found {
            let wanted = state["accelerations"][name.trim_end_matches('\'')].as_f64().unwrap();
            let difference = value.as_f64().unwrap() - wanted;
            assert!(difference.abs() < 1e-12 * (1.0 + wanted.abs()), "{kind}, {name}: {difference} of {wanted}");
        }
        let path = folder.path().join("robot/scenes/first.toml");
        let scene = std::fs::read_to_string(&path).unwrap().replace("\"1 s\"", "\"0.05 s\"");
        std::fs::write(&path, scene).unwrap();
        let (status, out, err) = tripos_in(folder.path(), &["simulate", "robot/scenes/first.toml"]);
        assert!(status == 0 && out.contains("digits are right at the end"), "{kind}: {out}{err}");
    }
}

/// Goal: a URDF file with loops is the robot of the MJCF file with the same loops. Method: the mass matrix and the
/// forcing of both at a closed state, and those of the tree by Pinocchio.
#[test]
fn a_leg_in_urdf_has_the_equations_of_the_leg_in_mjcf() {
    let folder = tempfile::tempdir().unwrap();
    let file = format!("{STEM}.connect.toml");
    let half = "<body name=\"half\" pos=\"-0.1503695567867184 0 -0.07586346536775274\" euler=\"0 14.32394487827058 0\">\
        <joint name=\"half_pin\" axis=\"0 1 0\" damping=\"0.02\"/>\
        <inertial pos=\"0.01 0 0.05\" mass=\"0.11\" fullinertia=\"0.0002 0.00021 0.00003 0 0.00001 0\"/></body>";
    let toe = "<joint joint1=\"ankle_roll\" joint2=\"hip_roll\" polycoef=\"0.05 -0.5 0 0 0\"/>";
    let mjcf = without(&description("leg_fourbar.xml"), &["sensor", "actuator"])
        .replace("armature=\"0.01\"", "")
        .replace("<body name=\"foot\"", &format!("{half}<body name=\"foot\""))
        .replace("</equality>", &format!("{toe}</equality>"));
    let models = [
        ("urdf", leg_in(folder.path(), &file)),
        ("mjcf", model_in(tempfile::tempdir().unwrap().path(), "leg.xml", &mjcf, &["--as-written"])),
    ];
    let state = reference(&file);
    let [urdf, mjcf] = models.map(|(name, text)| {
        std::fs::write(folder.path().join(format!("{name}.toml")), text).unwrap();
        equations(folder.path(), &format!("{name}.toml"), &state)
    });
    let places: Vec<usize> = urdf["unknowns"]
        .as_array()
        .unwrap()
        .iter()
        .map(|own| mjcf["unknowns"].as_array().unwrap().iter().position(|other| other == own).unwrap())
        .collect();
    let (own, other) = (numbers(&urdf["forcing"]), numbers(&mjcf["forcing"]));
    let size = own.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    for (row, place) in places.iter().enumerate() {
        let difference = own[row] - other[*place];
        assert!(difference.abs() < 1e-12 * size, "forcing {row} differs by {difference}");
        let (own, other) = (numbers(&urdf["mass_matrix"][row]), numbers(&mjcf["mass_matrix"][*place]));
        for (column, place) in places.iter().enumerate() {
            let difference = own[column] - other[*place];
            assert!(difference.abs() < 1e-12, "M {row} {column} differs by {difference}");
        }
    }
    let tree = tempfile::tempdir().unwrap();
    model_in(tree.path(), "leg.urdf", &description(&format!("{STEM}.urdf")), &["--as-written"]);
    assert_reference_values(tree.path(), "robot/model.toml", STEM);
}

/// Goal: a wrong file of loops is answered with its place, and nothing is written. Method: one mistake each.
#[test]
fn mistakes_of_a_loops_file_are_shown_with_their_place() {
    let hinge = description(&format!("{STEM}.hinge.toml"));
    let wrong = [
        (
            "unknown link",
            "link = \"coupler\"",
            "link = \"couple\"",
            "there is no link `couple`",
            "did you mean `coupler`?",
        ),
        ("unknown kind", "kind = \"hinge\"", "kind = \"hing\"", "there is no loop of the kind `hing`", "`hinge`"),
        ("unknown key", "axis = ", "axes = ", "unknown key `axes`", "did you mean `axis`?"),
        ("section", "[couplings.toe]", "[coupling.toe]", "unknown key `coupling`", "`couplings`"),
        ("no axis", "axis = [0.5, 0.8660254037844386, 0]", "", "has no `axis`", "axis = [0, 0, 1]"),
        (
            "zero axis",
            "axis = [0.5, 0.8660254037844386, 0]",
            "axis = [0, 0, 0]",
            "the axis has the length 0",
            "[0, 0, 1]",
        ),
        ("axis of a weld", "kind = \"hinge\"", "kind = \"weld\"", "has an axis, and is no hinge", "leave `axis` out"),
        ("turn of a point", "kind = \"hinge\"", "kind = \"connect\"", "has no orientation", "leave `rpy` out"),
        ("infinite", "xyz = [0.01, 0, -0.27]", "xyz = [inf, 0, -0.27]", "`xyz` is no finite number", "0.25"),
        ("not a number", "offset = 0.05", "offset = nan", "`offset` is no finite number", "0.25"),
        ("overflow", "offset = 0.05", "offset = 1e999", "`offset` is no finite number", "0.25"),
        ("text", "multiplier = -0.5", "multiplier = \"-0.5\"", "`multiplier` is no finite number", "0.25"),
        ("two numbers", "xyz = [0.01, 0, -0.27]", "xyz = [0.01, 0]", "no list of three numbers", "[0, 0, 0.25]"),
        (
            "degrees",
            "rpy = [0, 0, 0.5235987755982988] }\naxis",
            "rpy = [0, 0, 30] }\naxis",
            "more than two turns",
            "degrees",
        ),
        ("no end", "second = ", "third = ", "has no `second`", "`second = …`"),
        ("one link", "link = \"shank\"", "link = \"coupler\"", "are on the same link", "two different links"),
        ("unknown joint", "follows = \"hip_roll\"", "follows = \"hip_rol\"", "no moving joint `hip_rol`", "`hip_roll`"),
        ("fixed joint", "follows = \"hip_roll\"", "follows = \"pelvis_fixed\"", "no moving joint", "help:"),
        ("itself", "follows = \"hip_roll\"", "follows = \"ankle_roll\"", "follows itself", "move freely"),
        ("assembly", "knee = 0.1", "kne = 0.1", "there is no moving joint `kne`", "did you mean `knee`?"),
        (
            "twice",
            "[assembly]",
            "[couplings.more]\njoint = \"ankle_roll\"\nfollows = \"knee\"\n[assembly]",
            "already",
            "help:",
        ),
        (
            "value against its coupling",
            "knee = 0.1",
            "knee = 0.1\nankle_roll = 0.5",
            "the joint `ankle_roll` is at 0.5, and its coupling puts it at -0.05",
            "leave `ankle_roll` out",
        ),
        ("no TOML", "[assembly]", "[assembly", "unclosed", "valid TOML"),
        ("stated twice", "knee = 0.1", "knee = 0.1\nknee = 0.2", "`knee` is stated twice", "remove or rename"),
    ];
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("leg.urdf"), description(&format!("{STEM}.urdf"))).unwrap();
    let answer = |text: &str| {
        std::fs::write(folder.path().join("loops.toml"), text).unwrap();
        let (status, out, err) =
            tripos_in(folder.path(), &["new", "bad", "--from", "leg.urdf", "--loops", "loops.toml"]);
        assert!(status == 2 && !folder.path().join("bad").exists(), "{text}: {out}{err}");
        err
    };
    for (name, from, to, message, help) in wrong {
        assert!(hinge.contains(from), "{name}");
        let err = answer(&hinge.replace(from, to));
        assert!(err.contains(message) && err.contains(help), "{name}: {err}");
        assert!(err.contains("loops.toml:") && err.contains("help:"), "{name}: {err}");
    }
    assert!(answer("").contains("the file states no loop and no coupling"));
    let mimic = description("hand.urdf");
    std::fs::write(folder.path().join("leg.urdf"), &mimic).unwrap();
    assert!(answer("[couplings.a]\njoint = \"ring_mcp\"\nfollows = \"little_dip\"\n").contains("follows itself"));
    std::fs::write(folder.path().join("leg.xml"), description("leg_fourbar.xml")).unwrap();
    let arguments = ["new", "bad", "--from", "leg.xml", "--loops", "loops.toml"];
    let (status, _, err) = tripos_in(folder.path(), &arguments);
    assert!(status == 2 && err.contains("states its loops under `<equality>`") && err.contains("help:"), "{err}");
    let arguments = ["new", "bad", "--from", "leg.xml", "--loops", "absent.toml"];
    let (status, _, err) = tripos_in(folder.path(), &arguments);
    assert!(status == 2 && err.contains("absent.toml") && !folder.path().join("bad").exists(), "{err}");
}

/// Goal: loops that cannot close are told when the model is written, at their place in the file that states them.
/// Method: an end of a loop out of reach; a weld of two bodies of an MJCF file that a hinge holds apart. A value of a
/// joint that agrees with its coupling is accepted.
#[test]
fn loops_that_cannot_close_are_told_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let hinge = description(&format!("{STEM}.hinge.toml"));
    std::fs::write(folder.path().join("leg.urdf"), description(&format!("{STEM}.urdf"))).unwrap();
    let new =
        |name: &str, from: &str| tripos_in(folder.path(), &["new", name, "--from", from, "--loops", "loops.toml"]);
    std::fs::write(folder.path().join("loops.toml"), hinge.replace("knee = 0.1", "knee = 0.1\nankle_roll = -0.0501"))
        .unwrap();
    let (status, _, err) = new("good", "leg.urdf");
    assert!(status == 0 && err.is_empty(), "{err}");

    std::fs::write(folder.path().join("loops.toml"), hinge.replace("-0.27]", "-27]")).unwrap();
    let (status, out, err) = new("far", "leg.urdf");
    assert!(status == 0 && out.contains("new      far/model.toml"), "{out}{err}");
    assert!(err.starts_with("warning: `tripos check` refuses the model that was written:\n"), "{err}");
    assert!(err.contains("no pose with closed loops is near") && err.contains("loops.toml:14:"), "{err}");
    let (status, _, err) = tripos_in(folder.path(), &["check", "far/model.toml"]);
    assert!(status == 2 && err.contains("no pose with closed loops is near"), "{err}");

    let mjcf = r#"<mujoco><worldbody><body name="a"><joint name="j" axis="0 0 1"/>
        <inertial pos="0.1 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody>
        <equality>
        <connect name="held" body1="a" anchor="0 0 1"/><connect name="open" site1="s" site2="g"/>
        </equality></mujoco>"#
        .replace("</body>", "<site name=\"s\" pos=\"0 0 1\"/></body><site name=\"g\" pos=\"0 0 1.5\"/>");
    std::fs::write(folder.path().join("arm.xml"), mjcf).unwrap();
    let (status, out, err) = tripos_in(folder.path(), &["new", "arm", "--from", "arm.xml"]);
    assert!(status == 0 && out.contains("new      arm/model.toml"), "{out}{err}");
    assert!(err.contains("the joint cannot close its loop: `open_3` is open by 0.5 in every pose"), "{err}");
    assert!(err.contains("arm.xml:4:"), "{err}");
}

/// Goal: a weld holds the orientation that it states, and not one half a turn away, which satisfies the same three
/// equations. Method: a body that is welded half a turn away from where it is drawn, and a chain of four bars in a
/// plane whose end is welded, from guesses on both sides; the angles of the bars add up to whole turns.
#[test]
fn a_weld_holds_its_orientation_and_not_half_a_turn_from_it() {
    let folder = tempfile::tempdir().unwrap();
    let turned = r#"<mujoco><compiler angle="radian"/><worldbody>
        <body name="a"><freejoint name="f"/><geom size=".1"/>
        <body name="b" pos="0.3 0 0"><joint name="k"/><geom size=".1" pos=".1 0 0"/></body></body></worldbody>
        <equality><weld body1="world" body2="a" relpose="0 0 0 0 0 0 1"/></equality></mujoco>"#;
    std::fs::write(folder.path().join("turned.xml"), turned).unwrap();
    let (status, _, err) = tripos_in(folder.path(), &["new", "turned", "--from", "turned.xml"]);
    assert!(status == 0 && err.is_empty(), "{err}");
    let (status, out, err) = tripos_in(folder.path(), &["simulate", "turned/scenes/first.toml", "--json"]);
    assert_eq!(status, 0, "{err}");
    let state = &serde_json::from_str::<Value>(&out).unwrap()["state"];
    let of = |name: &str| state[name].as_f64().unwrap();
    assert!((of("q_f_7").abs() - 1.0).abs() < 1e-12 && of("q_f_4").abs() < 1e-12, "{state}");
    assert!(of("q_k").abs() < 1e-12, "the pin keeps the angle in which it is drawn: {state}");

    let mut model = "schema = 1\nname = \"chain\"\n[parameters]\nl = { unit = \"m\", value = 1, positive = true }\n\
                     m = { unit = \"kg\", value = 1, positive = true }\nx = { unit = \"m\", value = 1.5 }\n\
                     y = { unit = \"m\", value = 0.5 }\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[bodies]\n"
        .to_owned();
    for bar in 1..=4 {
        let _ =
            writeln!(model, "b{bar} = {{ mass = \"m\", inertia = {{ diagonal = [0, \"m*l^2/12\", \"m*l^2/12\"] }} }}");
    }
    model += "[joints]\n";
    for bar in 1..=4 {
        let to = if bar > 1 { format!("to = \"b{}\", at = [\"l\", 0, 0], ", bar - 1) } else { String::new() };
        let _ =
            writeln!(model, "j{bar} = {{ kind = \"pin\", axis = 3, body = \"b{bar}\", {to}centre = [\"l/2\", 0, 0] }}");
    }
    model += "end = { kind = \"weld\", body = \"b4\", at = [\"x\", \"y\", 0], body_at = [\"l\", 0, 0] }\n";
    std::fs::write(folder.path().join("chain.toml"), model).unwrap();
    let scene = |start: &str, guess: &str| {
        let text = format!("model = \"chain.toml\"\nspan = [0, 0.01]\n[start]\n{start}\nu_j1 = 0\n[guess]\n{guess}\n");
        std::fs::write(folder.path().join("scene.toml"), text).unwrap();
        tripos_in(folder.path(), &["simulate", "scene.toml", "--json"])
    };
    // The guesses' angles add up to 0.1 and to π.
    for guess in ["q_j2 = 1\nq_j3 = 0.5\nq_j4 = -1.9", "q_j2 = -1.5\nq_j3 = 2.4\nq_j4 = 1.7416"] {
        let (status, out, err) = scene("q_j1 = 0.5", guess);
        assert_eq!(status, 0, "{out}{err}");
        let run = serde_json::from_str::<Value>(&out).unwrap();
        let q: Vec<f64> = (1..=4).map(|bar| run["state"][format!("q_j{bar}")].as_f64().unwrap()).collect();
        let (mut angle, mut place) = (0.0, [0.0, 0.0]);
        for q in &q {
            angle += q;
            place = [place[0] + f64::cos(angle), place[1] + f64::sin(angle)];
        }
        assert!((f64::cos(angle) - 1.0).abs() < 1e-12, "{guess}: {q:?}");
        assert!((place[0] - 1.5).abs() < 1e-9 && (place[1] - 0.5).abs() < 1e-9, "{guess}: {place:?}");
    }
    // Positions closed, and the last bar turned by π.
    let all = "q_j1 = 0.3\nq_j2 = 0.5092290047524293\nq_j3 = -1.3552320556905315\nq_j4 = 3.6875957045278955";
    let (status, _, err) = scene(all, "");
    assert!(status == 2 && err.contains("the joint `end` is closed half a turn away from its orientation"), "{err}");
}
