//! Robot descriptions: `tripos new --from`.
//!
//! `UPDATE_EXPECT=1 cargo test` accepts new words; read them before you commit them.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::support::{root, tripos_in};
use expect_test::expect;
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

/// Descriptions whose reference values are in tests/data/robots, by other programs.
const DESCRIPTIONS: [&str; 14] = [
    "cassie_leg.xml",
    "delta.xml",
    "double_wishbone.xml",
    "hand.urdf",
    "hexapod.urdf",
    "kitchen_radian.xml",
    "kitchen_sink.xml",
    "leg_fourbar.xml",
    "panda_like.urdf",
    "quad_fixed_merge.urdf",
    "scara.urdf",
    "stewart.xml",
    "ur_like.urdf",
    "weld_gear.xml",
];

/// Text of a description.
pub fn description(file: &str) -> String {
    std::fs::read_to_string(root().join("tests/data/robots").join(file)).unwrap()
}

/// Text without the elements with these names.
pub fn without(text: &str, names: &[&str]) -> String {
    let mut text = text.to_owned();
    for name in names {
        while let Some(start) = text.find(&format!("<{name}>")) {
            let end = format!("</{name}>");
            let length = text[start..].find(&end).unwrap() + end.len();
            text.replace_range(start..start + length, "");
        }
    }
    text
}

/// Model made from a description in a folder; the arguments follow `new`.
pub fn model_in(folder: &Path, file: &str, text: &str, arguments: &[&str]) -> String {
    std::fs::write(folder.join(file), text).unwrap();
    let (status, out, err) = tripos_in(folder, &[&["new", "robot", "--from", file], arguments].concat());
    assert_eq!(status, 0, "{file}: {out}{err}");
    std::fs::read_to_string(folder.join("robot/model.toml")).unwrap()
}

/// Numbers of a JSON array.
pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Goal: an imported robot is the robot of the file. Method: energies, mass matrix and bias at random states, by
/// Pinocchio and MuJoCo (tests/data/robots/reference.py).
#[test]
fn robots_have_the_energies_and_equations_of_other_programs() {
    for file in DESCRIPTIONS {
        let folder = tempfile::tempdir().unwrap();
        let tree = without(&description(file), &["equality", "tendon", "sensor", "actuator", "keyframe"]);
        let floating: &[&str] = if file == "hexapod.urdf" { &["--floating"] } else { &[] };
        model_in(folder.path(), file, &tree, &[&["--as-written"], floating].concat());
        assert_reference_values(folder.path(), "robot/model.toml", file.split('.').next().unwrap());
    }
}

/// Compares a model in a folder with the reference values of the description `stem`, at each of its states. Damping,
/// friction and springs count as zero.
pub fn assert_reference_values(folder: &Path, path: &str, stem: &str) {
    let model = std::fs::read_to_string(folder.join(path)).unwrap();
    let mut off = String::new();
    for (name, _) in model.lines().filter_map(|line| line.split_once(" = ")) {
        if ["c_", "f_", "k_"].iter().any(|prefix| name.starts_with(prefix)) {
            let _ = writeln!(off, "{name} = 0");
        }
    }
    let reference: Value = serde_json::from_str(&description(&format!("{stem}.json"))).unwrap();
    let mut offsets = Vec::new();
    for state in reference["states"].as_array().unwrap() {
        let mut text = format!("[parameters]\n{off}[state]\n");
        let order = state["order"].as_array();
        for (name, value) in ["coordinates", "speeds"].iter().flat_map(|key| state[*key].as_object().unwrap()) {
            // A speed that follows another one is not stated.
            if name.starts_with("q_") || order.is_none_or(|order| order.iter().any(|own| own == name)) {
                let _ = writeln!(text, "{name} = {value}");
            }
        }
        std::fs::write(folder.join("state.toml"), text).unwrap();
        let arguments = ["evaluate", path, "--by", "kane", "--at", "state.toml", "--json"];
        let (status, out, err) = tripos_in(folder, &arguments);
        assert_eq!(status, 0, "{stem}: {out}{err}");
        let own: Value = serde_json::from_str(&out).unwrap();
        let kinetic = state["kinetic_energy"].as_f64().unwrap();
        let difference = own["kinetic_energy"].as_f64().unwrap() - kinetic;
        assert!(difference.abs() < 1e-12 * kinetic, "{stem}: T differs by {difference}");
        let potential = own["potential_energy"].as_f64().unwrap();
        offsets.push((potential - state["potential_energy"].as_f64().unwrap(), potential.abs()));
        let Some(order) = order else { continue };
        let unknowns = own["unknowns"].as_array().unwrap();
        let at = |name: &Value| {
            let rate = format!("{}'", name.as_str().unwrap());
            unknowns.iter().position(|unknown| *unknown == rate.as_str()).unwrap()
        };
        let places: Vec<usize> = order.iter().map(at).collect();
        let forcing = numbers(&own["forcing"]);
        let bias = numbers(&state["bias"]);
        let rows: Vec<Vec<f64>> = state["mass_matrix"].as_array().unwrap().iter().map(numbers).collect();
        let largest = |list: &[f64]| list.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let (size, mass) = (largest(&bias), largest(&rows.concat()));
        for (row, place) in places.iter().enumerate() {
            let difference = forcing[*place] + bias[row];
            assert!(difference.abs() < 1e-12 * size, "{stem}: the bias of {} differs by {difference}", order[row]);
            for (column, other) in places.iter().enumerate() {
                let entry = own["mass_matrix"][*place][*other].as_f64().unwrap();
                let difference = entry - rows[row][column];
                assert!(difference.abs() < 1e-12 * mass, "{stem}: M {row} {column} differs by {difference}");
            }
        }
    }
    let [(first, size), (second, other)] = offsets[..] else { panic!("{stem} has two states") };
    let spread = (second - first).abs();
    assert!(spread < 1e-12 * (1.0 + size + other), "{stem}: V differs by {spread}");
}

/// Goal: loops of an MJCF file are closed exactly, also in the symmetric pose of a Delta robot. Method: the motion
/// after a release, by MuJoCo with its stiffest equality; the scene that the command writes.
#[test]
fn robots_with_loops_move_as_in_mujoco() {
    for stem in ["leg_fourbar", "delta"] {
        let folder = tempfile::tempdir().unwrap();
        let file = format!("{stem}.xml");
        let text = without(&description(&file), &["tendon", "sensor", "actuator", "keyframe"]);
        model_in(folder.path(), &file, &text, &["--as-written"]);
        let path = folder.path().join("robot/scenes/first.toml");
        let scene = std::fs::read_to_string(&path).unwrap().replace("\"1 s\"", "\"0.1 s\"");
        std::fs::write(&path, scene).unwrap();
        let (status, out, err) = tripos_in(folder.path(), &["simulate", "robot/scenes/first.toml", "--json"]);
        assert_eq!(status, 0, "{stem}: {out}{err}");
        let own: Value = serde_json::from_str(&out).unwrap();
        let reference: Value = serde_json::from_str(&description(&format!("{stem}.motion.json"))).unwrap();
        for (name, value) in reference["coordinates"].as_object().unwrap() {
            let found = own["state"][name].as_f64().unwrap();
            assert!((found - value.as_f64().unwrap()).abs() < 1e-9, "{stem}, {name}: {found}, {value}");
        }
    }
}

/// A URDF file of one arm on a base; `JOINT` and `LINK` stand for more text.
const ARM: &str = r#"<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial>
      <origin xyz="0 0 0.2" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="0.03" iyy="0.03" izz="0.004" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual><origin xyz="0 0 0.2" rpy="0 1.5708 0"/><geometry><cylinder radius="0.03" length="0.4"/></geometry></visual>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="upper"/>
    <origin xyz="0 0 0.5" rpy="1.5708 0 0"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1.5" upper="1.5" effort="10" velocity="2"/>
    <dynamics damping="0.1" friction="0.2"/>
  </joint>
</robot>
"#;

/// Goal: people read and edit the model that an import writes. Method: snapshots of the model, the scene and the
/// answer, which are checked and run.
#[test]
fn an_arm_becomes_a_readable_model() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("arm.urdf"), ARM).unwrap();
    let (status, out, err) = tripos_in(folder.path(), &["new", "arm", "--from", "arm.urdf"]);
    assert_eq!((status, err.as_str()), (0, ""));
    let read = |file: &str| std::fs::read_to_string(folder.path().join(file)).unwrap();
    expect![[r#"
        new      arm/model.toml
        new      arm/scenes/first.toml
        left out digits of the angle 1.5708 rad: it is read as pi/2 (2 times)
        left out limit of effort
        left out limit of velocity
        left out the jump of dry friction at rest: the friction is smoothed below a rate of 0.01

        next:
          tripos check arm/model.toml
          tripos prove arm/model.toml
          tripos simulate arm/scenes/first.toml
    "#]]
    .assert_eq(&out);
    expect![[r##"
        # Made from arm.urdf (URDF) by `tripos new --from`. Every section and key: docs/model.md.
        # Left out: digits of the angle 1.5708 rad: it is read as pi/2 (2 times).
        # Left out: limit of effort.
        # Left out: limit of velocity.
        # Left out: the jump of dry friction at rest: the friction is smoothed below a rate of 0.01.
        schema = 1
        name = "arm"
        source = "URDF file arm.urdf"

        [parameters]
        g = { unit = "m/s^2", value = 9.81, positive = true, about = "acceleration of free fall" }
        z_shoulder = { unit = "m", value = 0.5, about = "position of the joint shoulder on the ground" }
        cz_upper = { unit = "m", value = 0.2, about = "mass centre of upper from the joint shoulder" }
        m_upper = { unit = "kg", value = 2, positive = true, about = "mass of upper" }
        Ixx_upper = { unit = "kg*m^2", value = 0.03, positive = true, about = "moments of upper about its mass centre" }
        Izz_upper = { unit = "kg*m^2", value = 0.004, positive = true }
        c_shoulder = { unit = "N*m*s/rad", value = 0.1, about = "damping of the joint shoulder" }
        f_shoulder = { unit = "N*m", value = 0.2, about = "dry friction of the joint shoulder" }
        slow_shoulder = { unit = "rad/s", value = 0.01, about = "rate below which the dry friction is smoothed; the description states none" }
        min_shoulder = { unit = "rad", value = -1.5 }
        max_shoulder = { unit = "rad", value = 1.5 }

        [inputs]
        tau_shoulder = { unit = "N*m", about = "load of the drive of shoulder" }

        [inertial]
        frame = "N"
        origin = "O"

        [bodies]
        upper = { mass = "m_upper", inertia = { diagonal = ["Ixx_upper", "Ixx_upper", "Izz_upper"] } }

        [joints]
        shoulder = { kind = "pin", axis = 3, body = "upper", at = [0, 0, "z_shoulder"], turned = { sequence = "1", angles = ["pi/2"] }, centre = [0, 0, "cz_upper"] }

        [gravity]
        frame = "N"
        acceleration = [0, 0, "-g"]

        [torques]
        shoulder_damping = { on = "upper", frame = "upper_frame", vector = [0, 0, "-c_shoulder*q_shoulder'"] }
        shoulder_drive = { on = "upper", frame = "upper_frame", vector = [0, 0, "tau_shoulder"] }

        [friction]
        shoulder_friction = { on = "upper", frame = "upper_frame", axis = 3, torque = "f_shoulder", smoothing = "slow_shoulder" }

        [domain]
        shoulder_min = "q_shoulder > min_shoulder"
        shoulder_max = "q_shoulder < max_shoulder"

        [shapes]
        upper = { kind = "cylinder", axis = 1, radius = "0.03 m", length = "0.4 m", frame = "upper_frame", at = "shoulder", position = [0, 0, "0.2 m"] }
    "##]].assert_eq(&read("arm/model.toml"));
    expect![[r##"
        # A run of ../model.toml. What every key means: docs/scene.md.
        schema = 1
        title = "Released"
        about = "The robot is released at rest. Its drives exert nothing: give them values under [inputs]."
        span = [0, "1 s"]

        [start]
        q_shoulder = 0
        "q_shoulder'" = 0

        [integration]
        rtol = 1e-9
        atol = 1e-12

        [[figures]]
        kind = "states"
        caption = "Motion of the joints"
    "##]]
    .assert_eq(&read("arm/scenes/first.toml"));
    let (status, out, err) = tripos_in(folder.path(), &["simulate", "arm/scenes/first.toml"]);
    assert!(status == 0 && out.contains("digits are right at the end"), "{out}{err}");
}

/// Goal: a wrong description is answered with its place in that file, and nothing is written. Method: one mistake
/// each.
#[test]
fn mistakes_of_descriptions_are_shown_with_their_place() {
    let wrong = [
        (
            "two parents",
            "</robot>",
            "<link name=\"x\"/><joint name=\"j2\" type=\"fixed\"><parent link=\"x\"/><child link=\"upper\"/></joint></robot>",
            "two joints, `shoulder` and `j2`, carry the link `upper`",
        ),
        ("unconnected", "</robot>", "<link name=\"loose\"/></robot>", "no joint carries the link `loose`"),
        ("unknown link", "child link=\"upper\"", "child link=\"uper\"", "did you mean `upper`?"),
        ("cycle", "parent link=\"base\"", "parent link=\"upper\"", "is in a loop of joints"),
        ("inertia", "izz=\"0.004\"", "izz=\"0.4\"", "exceeds the sum of the others"),
        ("negative mass", "mass value=\"2\"", "mass value=\"-2\"", "the mass -2 is negative"),
        ("degrees", "rpy=\"1.5708 0 0\"", "rpy=\"90 0 0\"", "in radians, not in degrees"),
        (
            "limits in degrees",
            "lower=\"-1.5\" upper=\"1.5\"",
            "lower=\"-180\" upper=\"180\"",
            "in radians, not in degrees",
        ),
        ("NaN", "xyz=\"0 0 0.5\"", "xyz=\"0 0 nan\"", "`nan`, which is no number"),
        ("commas", "xyz=\"0 0 0.5\"", "xyz=\"0, 0, 0.5\"", "separate numbers by blanks"),
        ("two numbers", "xyz=\"0 0 0.5\"", "xyz=\"0 0.5\"", "has 2 numbers"),
        ("type", "type=\"revolute\"", "type=\"revolut\"", "did you mean `revolute`?"),
        ("axis", "axis xyz=\"0 0 1\"", "axis xyz=\"0 0 0\"", "the axis has the length 0"),
        ("macro", "xyz=\"0 0 0.5\"", "xyz=\"0 0 ${l}\"", "xacro robot.urdf.xacro > robot.urdf"),
        ("mimic", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 1\"/><mimic joint=\"shoulder\"/>", "follows itself"),
        ("limits", "lower=\"-1.5\" upper=\"1.5\"", "lower=\"1.5\" upper=\"-1.5\"", "exchange the two limits"),
        ("missing moment", "ixx=\"0.03\" ", "", "`inertia` has no `ixx`"),
        ("no XML", "<link name=\"base\"/>", "<link name=\"base\">", "this is no XML that can be read"),
        ("another root", "robot", "sdf", "neither `robot` (URDF) nor `mujoco` (MJCF)"),
        ("nothing moves", "type=\"revolute\"", "type=\"fixed\"", "no body of this robot moves"),
    ];
    for (name, from, to, message) in wrong {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("bad.urdf"), ARM.replace(from, to)).unwrap();
        let (status, out, err) = tripos_in(folder.path(), &["new", "bad", "--from", "bad.urdf"]);
        assert!(status == 2 && err.contains(message) && err.contains("bad.urdf"), "{name}: {out}{err}");
        assert!(err.contains("help:") && !folder.path().join("bad").exists(), "{name}: {err}");
    }
    let folder = tempfile::tempdir().unwrap();
    let deep = format!("<mujoco><worldbody>{}</worldbody></mujoco>", "<body>".repeat(100_000));
    for (text, message) in [
        (
            "<mujoco><worldbody><body name=\"a\"><joint axis=\"0 0 0\"/></body></worldbody></mujoco>",
            "the axis has the length 0",
        ),
        (
            "<mujoco><worldbody><body name=\"a\" quat=\"1 0 0 0\" euler=\"0 0 9\"/></worldbody></mujoco>",
            "state the orientation",
        ),
        (
            "<mujoco><worldbody><body><joint/><inertial pos=\"0 0 0\" mass=\"-1\" diaginertia=\"1 1 1\"/></body></worldbody></mujoco>",
            "the mass -1 is negative",
        ),
        ("<mujoco><include file=\"other.xml\"/></mujoco>", "the file includes another one"),
        (
            "<mujoco><worldbody><body name=\"a\"><joint/><geom size=\"-1\"/></body></worldbody></mujoco>",
            "needs 1 positive numbers",
        ),
        ("<mujoco><worldbody><body><joint class=\"b\"/></body></worldbody></mujoco>", "there is no default class `b`"),
        ("<mujoco><equality><connect body1=\"a\" anchor=\"0 0 0\"/></equality></mujoco>", "there is no body `a`"),
        ("<!DOCTYPE a [<!ENTITY b \"c\">]><mujoco>&b;</mujoco>", "this is no XML that can be read"),
        (&deep, "nested more than 200 deep"),
    ] {
        std::fs::write(folder.path().join("bad.xml"), text).unwrap();
        let (status, out, err) = tripos_in(folder.path(), &["new", "bad", "--from", "bad.xml"]);
        assert!(status == 2 && err.contains(message) && err.contains("bad.xml"), "{text:.80}: {out}{err}");
        assert!(!folder.path().join("bad").exists());
    }
}

/// Goal: parts of descriptions that were once lost or refused. Method: small files, each with lines that its model must
/// have; the first scene of each runs.
#[test]
fn unusual_parts_of_descriptions_are_read() {
    let sphere = "<geom size=\"0.1\" mass=\"1\"/>";
    let mjcf = |bodies: &str, rest: &str| {
        format!("<mujoco><compiler angle=\"radian\"/><worldbody>{bodies}</worldbody>{rest}</mujoco>")
    };
    let pair = format!(
        "<body name=\"a\"><joint name=\"j\"/><geom size=\"0.1\" mass=\"1\" pos=\"0.3 0 0\"/></body>\
         <body name=\"b\" pos=\"1 0 0\"><joint name=\"k\"/>{sphere}</body>"
    );
    let oblique = "<axis xyz=\"0.95105651629515 0 0.30901699437495\"/>";
    let urdf = |from: &str, to: &str| ARM.replace(from, to);
    let follower = "</robot>".to_owned()
        + "<link name=\"lower\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial></link>\
           <joint name=\"elbow\" type=\"continuous\"><parent link=\"upper\"/><child link=\"lower\"/>\
           <mimic joint=\"shoulder\" multiplier=\"2\" offset=\"0.3\"/></joint></robot>";
    let files = [
        (
            "frame.xml",
            mjcf(
                "<body name=\"a\"><frame pos=\"0.2 0 0\"><joint name=\"j\" axis=\"0 1 0\"/></frame><geom size=\"0.1\" mass=\"1\"/></body>",
                "",
            ),
            "cx_a = { unit = \"m\", value = -0.2",
        ),
        (
            "inertial.xml",
            mjcf(
                "<body name=\"a\"><joint name=\"j\" axis=\"0 1 0\"/><frame pos=\"0.2 0 0\"><inertial pos=\"0.1 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/></frame></body>",
                "",
            ),
            "cx_a = { unit = \"m\", value = 0.3",
        ),
        (
            "anchor.xml",
            mjcf(
                &format!(
                    "<body name=\"c\"><joint name=\"j\"/>{sphere}</body><body name=\"g\" pos=\"0.6 0.3 0.4\"><freejoint name=\"f\"/>{sphere}</body>"
                ),
                "<equality><weld name=\"w\" body1=\"c\" body2=\"g\" anchor=\"0.1 0.2 0.3\" relpose=\"0.6 0.3 0.4 1 0 0 0\"/></equality>",
            ),
            "x_w = { unit = \"m\", value = 0.6",
        ),
        (
            "inactive.xml",
            format!(
                "<mujoco><default><equality active=\"false\"/></default><worldbody>{pair}</worldbody><equality><joint joint1=\"j\" joint2=\"k\"/></equality></mujoco>"
            ),
            "Left out: `joint` that is not active",
        ),
        (
            "offset.xml",
            mjcf(&pair, "<equality><joint joint1=\"j\" joint2=\"k\" polycoef=\"0.2 1 0 0 0\"/></equality>"),
            "j_follows = \"q_j = a0_j + q_k\"",
        ),
        (
            "unlimited.xml",
            mjcf("<body name=\"a\"><joint name=\"j\" range=\"0 0\"/><geom size=\"0.1\" mass=\"1\"/></body>", ""),
            "j = { kind = \"pin\"",
        ),
        ("type.xml", format!("<!DOCTYPE mujoco>{}", mjcf(&pair, "")), "k = { kind = \"pin\""),
        ("oblique.urdf", urdf("<axis xyz=\"0 0 1\"/>", oblique), "kind = \"pin\", axis = 3"),
        (
            "endless.urdf",
            urdf("lower=\"-1.5\" upper=\"1.5\"", "lower=\"-1e16\" upper=\"inf\""),
            "shoulder = { kind = \"pin\"",
        ),
        (
            "half_endless.urdf",
            urdf("lower=\"-1.5\" upper=\"1.5\"", "lower=\"0.2\" upper=\"1000000\""),
            "[domain]\nshoulder_min = \"q_shoulder > min_shoulder\"\n\n",
        ),
        (
            "follower.urdf",
            urdf("</robot>", &follower.replacen("</robot>", "", 1)),
            "elbow_follows = \"q_elbow = a0_elbow + a1_elbow*q_shoulder\"",
        ),
        ("slip.urdf", urdf("damping=\"0.1\"", "dampin=\"0.1\""), "Left out: unknown attribute `dampin` of `dynamics`"),
    ];
    for (file, text, line) in files {
        let folder = tempfile::tempdir().unwrap();
        let model = model_in(folder.path(), file, &text, &[]);
        assert!(model.contains(line), "{file}: {model}");
        let (status, out, err) = tripos_in(folder.path(), &["simulate", "robot/scenes/first.toml"]);
        assert!(status == 0 && out.contains("digits are right at the end"), "{file}: {out}{err}");
    }
}
