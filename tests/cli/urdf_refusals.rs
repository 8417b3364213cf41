//! Models that URDF cannot state: `tripos emit --language urdf` refuses them.
//!
//! `UPDATE_EXPECT=1 cargo test` accepts new words; read them before you commit them.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::robots_as_urdf::ARM;
use crate::support::{root, tripos_in};
use expect_test::expect;
use std::fmt::Write;

/// Goal: a model that URDF cannot state is refused with the place and the reason. Method: one change each; snapshots.
#[test]
fn models_that_are_no_tree_of_joints_are_refused() {
    let bar = "D = { from = \"C\", frame = \"G\", position = [0, 0, \"l\"] }";
    let changes = [
        ("no value", "l = \"0.3 m\"", "l = { unit = \"m\" }"),
        ("absolute angle", "G = { from = \"F\"", "G = { from = \"N\""),
        ("half the angle", "angle = \"p\"", "angle = \"p/2\""),
        ("two coordinates", "angle = \"p\"", "angle = \"p - q\""),
        ("driven", "angle = \"p\"", "angle = \"p + g*t^2/l\""),
        ("cam", bar, "D = { from = \"C\", frame = \"G\", position = [0, 0, \"l*sin(q)\"] }"),
        ("loop", "[gravity]", "[constraints]\nrope = \"sin(q) = sin(p)^2\"\n[gravity]"),
    ];
    let mut answers = String::new();
    for (name, from, to) in changes {
        let folder = tempfile::tempdir().unwrap();
        assert!(ARM.contains(from), "{name}");
        let text = ARM.replace(from, to);
        // A loop leaves one speed.
        let text = if text.contains("rope") { text.replace("v = \"p'\"\n", "") } else { text };
        std::fs::write(folder.path().join("arm.toml"), text).unwrap();
        let arguments = ["emit", "arm.toml", "--language", "urdf", "--out", "written"];
        let (status, out, err) = tripos_in(folder.path(), &arguments);
        assert!(status == 2 && out.is_empty() && !folder.path().join("written").exists(), "{name}: {out}{err}");
        let _ = writeln!(answers, "{name}:\n{err}");
    }
    expect![[r#"
        no value:
        error: the parameter `l` has no value
         --> arm.toml:5:1
          |
        5 | l = { unit = "m" }
          | ^
          |
          = help: URDF states numbers: add `value = …` to the parameter

        absolute angle:
        error: the body `lower` has no joint of URDF: the frame `G` is not turned from `F`, although its position is fixed in `F`
          --> arm.toml:18:1
           |
        18 | G = { from = "N", axis = 1, angle = "p" }
           | ^
           |
           = help: URDF measures each joint from the link that carries it: measure `G` from `F`, by a relative angle

        half the angle:
        error: `p` is the coordinate of no joint of URDF: each joint that it moves turns or slides by a multiple of it
         --> arm.toml:9:1
          |
        9 | p = { unit = "rad" }
          | ^
          |
          = help: choose the angle, or the displacement, of a joint as the coordinate

        two coordinates:
        error: the body `lower` has no joint of URDF: the turn of the frame `G` depends on several coordinates
          --> arm.toml:18:1
           |
        18 | G = { from = "F", axis = 1, angle = "p - q" }
           | ^
           |
           = help: a joint of URDF turns by one coordinate of its own, or by one that follows it with a constant factor: choose the relative angle as a coordinate

        driven:
        error: the body `lower` has no joint of URDF: the turn of the frame `G` is not a constant plus a constant times one coordinate
          --> arm.toml:18:1
           |
        18 | G = { from = "F", axis = 1, angle = "p + g*t^2/l" }
           | ^
           |
           = help: a joint of URDF turns by one coordinate of its own, or by one that follows it with a constant factor: choose the relative angle as a coordinate

        cam:
        error: the body `lower` has no joint of URDF: the position of `D` is not a constant plus constants times coordinates
          --> arm.toml:21:1
           |
        21 | D = { from = "C", frame = "G", position = [0, 0, "l*sin(q)"] }
           | ^
           |
           = help: URDF has joints that slide by a coordinate and joints that turn by one: place the point by constant components, and by coordinates with constant factors

        loop:
        error: the equation `rope` between coordinates closes a loop: URDF states trees of joints alone
          --> arm.toml:25:1
           |
        25 | rope = "sin(q) = sin(p)^2"
           | ^^^^
           |
           = help: leave the joints and constraints that close loops out of a copy of the model, and close the loops in the program that reads the file

    "#]].assert_eq(&answers);
}

/// Goal: library models and requests that have no description are refused with a way out. Method: snapshots.
#[test]
fn linkages_balls_and_equations_are_refused() {
    let mut answers = String::new();
    for (name, arguments) in [
        ("a ball of Euler parameters", &["models/satellite"][..]),
        ("a linkage", &["models/four_bar"]),
        ("a scene", &["models/furuta/scenes/swing.toml"]),
        ("equations", &["models/furuta", "--formulation", "kane"]),
        ("functions", &["models/furuta", "--functions", "mass_matrix"]),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("written");
        let all = [&["emit", "--language", "urdf", "--out", out.to_str().unwrap()], arguments].concat();
        let (status, _, err) = tripos_in(&root(), &all);
        assert!(status == 2 && !out.exists(), "{name}: {err}");
        let _ = writeln!(answers, "{name}:\n{err}");
    }
    expect![[r#"
        a ball of Euler parameters:
        error: URDF has no ball joint: the frame `S` turns by Euler parameters
          --> models/satellite/model.toml:20:17
           |
        20 | bus = { frame = "S", mass = "M", inertia = { diagonal = ["A", "B", "C"] } }
           |                 ^^^
           |
           = help: state the turn by three angles, as `sequence = "123"` does, or free the body in all directions

        a linkage:
        error: the equation `loop_x` between coordinates closes a loop: URDF states trees of joints alone
          --> models/four_bar/model.toml:63:1
           |
        63 | loop_x = { equation = "a*cos(q1) + b*cos(q2) = d + c*cos(q3)", enforced_by = "pin_qx", about = "Q and R have one place" }
           | ^^^^^^
           |
           = help: leave the joints and constraints that close loops out of a copy of the model, and close the loops in the program that reads the file

        a scene:
        error: a scene has no form in URDF
        help: give the model file in place of the scene

        equations:
        error: a robot description in URDF has no equations
        help: leave `--formulation` out, or give another language

        functions:
        error: functions can be chosen in C, Python, MATLAB and for CasADi
        help: leave `--functions` out, or give one of these languages

    "#]].assert_eq(&answers);
}
