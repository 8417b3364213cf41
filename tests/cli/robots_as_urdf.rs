//! Models as robot descriptions: `tripos emit --language urdf`.
//!
//! Truth: Pinocchio's values of the descriptions that were read (tests/data/robots), and each model itself after its
//! description is read again.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::robots::assert_reference_values;
use crate::support::{root, tripos_in};
use expect_test::expect;
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

/// Runs the command in a folder, which must succeed. Returns standard output and standard error.
fn tripos(folder: &Path, arguments: &[&str]) -> (String, String) {
    let (status, out, err) = tripos_in(folder, arguments);
    assert_eq!(status, 0, "{arguments:?}: {out}{err}");
    (out, err)
}

/// Text of the description of a model in a folder, which is read again as the folder `again`.
fn written_and_read(folder: &Path, model: &str) -> String {
    tripos(folder, &["emit", model, "--language", "urdf", "--out", "written"]);
    let entries = std::fs::read_dir(folder.join("written")).unwrap().map(|entry| entry.unwrap().path());
    let file = entries.into_iter().next().unwrap();
    tripos(folder, &["new", "again", "--from", file.to_str().unwrap(), "--as-written"]);
    std::fs::read_to_string(file).unwrap()
}

/// Folder with a model of this text, and the text of its description, which is read again as the folder `again`.
fn folder_with(model: &str, text: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(model), text).unwrap();
    let description = written_and_read(folder.path(), model);
    (folder, description)
}

/// Goal: a description that is read, written and read again is the same robot. Method: energies, mass matrix and bias
/// at random states, by Pinocchio from the first description.
#[test]
fn descriptions_survive_reading_and_writing() {
    for stem in ["hand", "hexapod", "panda_like", "quad_fixed_merge", "scara", "ur_like"] {
        let folder = tempfile::tempdir().unwrap();
        let path = root().join(format!("tests/data/robots/{stem}.urdf"));
        let floating: &[&str] = if stem == "hexapod" { &["--floating"] } else { &[] };
        let arguments = [&["new", "robot", "--from", path.to_str().unwrap(), "--as-written"], floating].concat();
        tripos(folder.path(), &arguments);
        written_and_read(folder.path(), "robot/model.toml");
        assert_reference_values(folder.path(), "again/model.toml", stem);
        // Damping, dry friction and the points of tools are there again.
        let lines = |folder_name: &str, section: &str| {
            let model = std::fs::read_to_string(folder.path().join(folder_name).join("model.toml")).unwrap();
            let rest = model.split_once(&format!("\n[{section}]\n")).map_or("", |(_, rest)| rest);
            let entries = rest.split("\n\n").next().unwrap_or("").lines().map(str::to_owned);
            entries.filter(|line| !line.contains("_drive")).collect::<Vec<_>>()
        };
        for section in ["torques", "forces", "friction"] {
            assert_eq!(lines("robot", section), lines("again", section), "{stem}: {section}");
        }
        assert_eq!(lines("robot", "points").len(), lines("again", "points").len(), "{stem}");
        // The sections name their numbers by parameters. Limits of coupled joints are written for each of them.
        let stems = if stem == "hand" { &["c_", "f_"][..] } else { &["c_", "f_", "min_", "max_"] };
        let of_joints = |folder_name: &str| {
            let all = lines(folder_name, "parameters").into_iter();
            all.filter(|line| stems.iter().any(|stem| line.starts_with(stem))).collect::<Vec<_>>()
        };
        assert_eq!(of_joints("robot"), of_joints("again"), "{stem}");
        assert!(stem != "scara" || lines("robot", "friction").len() > 1, "scara has dry friction");
    }
}

/// Values of `tripos evaluate` for a model in a folder, at a state.
fn evaluated(folder: &Path, model: &str, state: &[(String, f64)]) -> Value {
    let mut text = "[state]\n".to_owned();
    for (name, value) in state {
        let _ = writeln!(text, "\"{name}\" = {value}");
    }
    std::fs::write(folder.join("state.toml"), text).unwrap();
    let arguments = ["evaluate", model, "--by", "lagrange", "--at", "state.toml", "--json"];
    serde_json::from_str(&tripos(folder, &arguments).0).unwrap()
}

/// Numbers of a JSON value, in their order.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(list) => list.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().unwrap()],
    }
}

/// Asserts that the description of a model, read again, has the same mass matrix and the same forcing. `names` are the
/// coordinates of the model, each with its name after reading, and with the value after reading for a value of 1.
fn assert_same_robot(folder: &Path, model: &str, names: &[(&str, &str, f64)]) {
    let mut seed = 11_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 40) as f64 / f64::from(1 << 24) * 2.0 - 1.0
    };
    for _ in 0..2 {
        let values: Vec<(f64, f64)> = names.iter().map(|_| (random(), random())).collect();
        let each = || names.iter().zip(&values);
        let own: Vec<(String, f64)> = each()
            .flat_map(|((name, ..), (q, rate))| [((*name).to_owned(), *q), (format!("{name}'"), *rate)])
            .collect();
        let read: Vec<(String, f64)> = each()
            .flat_map(|((_, name, unit), (q, rate))| {
                [((*name).to_owned(), q * unit), (format!("{name}'"), rate * unit)]
            })
            .collect();
        let own = evaluated(folder, model, &own);
        let read = evaluated(folder, "again/model.toml", &read);
        let place = |value: &Value, name: &str| {
            let unknown = format!("{name}''");
            let unknowns = value["unknowns"].as_array().unwrap();
            unknowns.iter().position(|other| *other == unknown.as_str()).unwrap_or_else(|| panic!("{unknowns:?}"))
        };
        let size = numbers(&own["mass_matrix"]).into_iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        let forcing = numbers(&own["forcing"]).into_iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        for (name, other, unit) in names {
            let (row, other_row) = (place(&own, name), place(&read, other));
            let found = read["forcing"][other_row].as_f64().unwrap() * unit;
            let difference = own["forcing"][row].as_f64().unwrap() - found;
            assert!(difference.abs() < 1e-12 * forcing, "{model}: the forcing of {name} differs by {difference}");
            for (name, other, other_unit) in names {
                let (column, other_column) = (place(&own, name), place(&read, other));
                let entry =
                    |value: &Value, row: usize, column: usize| value["mass_matrix"][row][column].as_f64().unwrap();
                let found = entry(&read, other_row, other_column) * unit * other_unit;
                let difference = entry(&own, row, column) - found;
                assert!(difference.abs() < 1e-12 * size, "{model}: M {row} {column} differs by {difference}");
            }
        }
    }
}

/// Goal: robots by frames and points, or by joints, are written as they are. Method: each library model of a robot
/// against its description, read again.
#[test]
fn library_robots_are_the_same_robots_after_writing() {
    let six = ["q1", "q2", "q3", "q4", "q5", "q6"].map(|name| (name, format!("q_{name}")));
    let six: Vec<(&str, &str, f64)> = six.iter().map(|(name, other)| (*name, other.as_str(), 1.0)).collect();
    let furuta = [("theta1", "q_motor", 1.0), ("theta2", "q_joint", 1.0)];
    for (model, names) in [("models/puma560", &six[..]), ("benches/models/rx90.toml", &six), ("models/furuta", &furuta)]
    {
        let folder = tempfile::tempdir().unwrap();
        let model = root().join(model);
        written_and_read(folder.path(), model.to_str().unwrap());
        assert_same_robot(folder.path(), model.to_str().unwrap(), names);
    }
}

/// A model with every kind of tree joint that URDF can state, and with bodies that have no joint of their own.
const KINDS: &str = r#"name = "every kind & <more>"
[parameters]
g = "9.81 m/s^2"
m = "2 kg"
A = { unit = "kg*m^2", value = 0.05 }
B = { unit = "kg*m^2", value = 0.06 }
C = { unit = "kg*m^2", value = 0.03 }
D = { unit = "kg*m^2", value = 0.004 }
l = "0.3 m"
h = "0.2 m"
a = { unit = "rad", value = 0.7 }
k = { unit = "rad", value = 0.25 }
c = { unit = "N*m*s", value = 0.02 }
e = { unit = "rad", value = 1e-9 }
R = "0.1 m"
[inputs]
drive = { unit = "N*m" }
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
[bodies]
base = { mass = "m", inertia = { diagonal = ["A", "B", "C"], products = ["D", "-D", "D/2"] } }
arm = { mass = "m", inertia = { diagonal = ["B", "A", "C"], products = ["D", 0, "-D"] } }
tool = { mass = "m/2", inertia = { diagonal = ["A", "B", "C"] } }
nut = { mass = "m/3", inertia = { diagonal = ["C", "A", "B"] } }
rod = { mass = "m", inertia = { diagonal = ["A", "C", "B"], products = [0, "D", 0] } }
top = { mass = "m", inertia = { diagonal = ["A", "B", "C"] } }
puck = { mass = "m", inertia = { diagonal = ["A", "B", "C"], products = ["D", "D", "D"] } }
wheel = { mass = "m/4", inertia = { diagonal = ["A", "B", "C"] } }
[joints]
rail = { kind = "slider", axis = [1, 2, 2], body = "base", at = ["l", 0, "h"], turned = { sequence = "13", angles = ["a", "pi/3"] }, centre = [0, "h", "l"] }
swing = { kind = "pin", axis = [1, 0, 2], body = "arm", to = "base", at = ["h", "l", 0], turned = { sequence = "2", angles = ["-pi/2"] }, centre = ["l", "h", 0], coordinates = ["phi"], speeds = ["w"] }
flange = { kind = "weld", body = "tool", to = "arm", at = ["l", 0, "h"], turned = { sequence = "321", angles = ["a", "pi/2 - e", "k"] }, centre = [0, 0, "h"] }
thread = { kind = "screw", axis = 2, lead = "h", body = "nut", to = "arm", at = [0, "h", "l"], centre = ["h", 0, 0] }
bush = { kind = "cylinder", axis = 1, body = "rod", to = "nut", at = [0, 0, "l"], centre = ["l/2", 0, "h"] }
shoulder = { kind = "ball", sequence = "313", body = "top", to = "rod", at = ["l", 0, 0], centre = [0, 0, "l"] }
floor = { kind = "planar", axis = 1, body = "puck", turned = { sequence = "2", angles = ["a"] }, at = [0, 0, "h"], centre = ["h", 0, "l"] }
axle = { kind = "pin", axis = 3, body = "wheel", to = "puck", at = [0, "l", "h"], centre = [0, "h", "l/2"] }
[constraints]
gear = "q_axle = k + 2*phi"
[points]
tip = { from = "swing", frame = "arm_frame", position = ["l", "l", 0] }
load = { from = "shoulder", frame = "top_frame", position = ["l", "h", 0] }
[particles]
bob = { point = "load", mass = "m/5" }
[torques]
motor = { on = "wheel", against = "puck", frame = "puck_frame", vector = [0, 0, "drive - c*q_axle'"] }
[springs]
pull = { on = "puck", against = "base", stiffness = "50 N/m" }
[domain]
low = "phi > -1"
high = "2*phi + 1 < 2 + k"
near = "abs(q_rail) < l"
far = "q_bush_2^2 < 9*l^2"
[shapes]
rod = { kind = "cylinder", axis = 1, radius = "R/2", length = "l", body = "rod" }
ball = { kind = "sphere", radius = "R", frame = "top_frame", at = "load" }
disk = { kind = "disk", axis = 3, radius = "R", thickness = "R/4", body = "wheel" }
line = { kind = "line", through = ["O", "tip"] }
"#;

/// Goal: every kind of joint has the coordinates of the model. Method: a model with all of them, by mass matrix and
/// forcing after reading again; without the spring, which URDF cannot state. The answer is a snapshot.
#[test]
fn every_kind_of_joint_keeps_its_coordinates() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("kinds.toml"), KINDS).unwrap();
    let arguments = ["emit", "kinds.toml", "--language", "urdf", "--out", "written"];
    let (_, err) = tripos(folder.path(), &arguments);
    expect![[r#"
        left out: inputs `drive`: URDF states no drives
        left out: conditions `far`: none is a constant bound of a joint with one coordinate, or they exclude one another
        left out: loads `pull`: none is damping or dry friction between a link and the link that carries it
        left out: loads `motor`: only their damping is written
        left out: shape `line`: a line
        note: mass or a moment of inertia of the links `q_thread_follower_link`, `q_bush_2_link`, `q_shoulder_1_link`, `q_shoulder_2_link` is zero: MuJoCo and Gazebo refuse such links
        each coordinate of the model belongs to one joint, with the same zero and sign; parameters have their default values
    "#]].assert_eq(&err);
    let bare = KINDS.replace("pull = { on = \"puck\", against = \"base\", stiffness = \"50 N/m\" }", "");
    std::fs::write(folder.path().join("kinds.toml"), bare.replace("[springs]", "")).unwrap();
    let text = written_and_read(folder.path(), "kinds.toml");
    for part in [
        "<robot name=\"every kind &amp; &lt;more&gt;\">",
        "<limit lower=\"-0.3\" upper=\"0.3\" effort=\"1000000\" velocity=\"1000000\"/>",
        "<limit lower=\"-1\" upper=\"0.625\" effort=\"1000000\" velocity=\"1000000\"/>",
        "<limit lower=\"-1000000\" upper=\"1000000\" effort=\"1000000\" velocity=\"1000000\"/>",
        "<limit lower=\"-1.75\" upper=\"1.5\" effort=\"1000000\" velocity=\"1000000\"/>\n    <dynamics damping=\"0.02\" \
         friction=\"0\"/>\n    <mimic joint=\"swing\" multiplier=\"2\" offset=\"0.25\"/>",
        "<joint name=\"floor\" type=\"planar\">",
        "<geometry><cylinder radius=\"0.05\" length=\"0.3\"/></geometry>",
        "<geometry><cylinder radius=\"0.1\" length=\"0.025\"/></geometry>",
        "<geometry><sphere radius=\"0.1\"/></geometry>",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    // The screw is read with its advance as the coordinate: the lead over a turn for each radian.
    let advance = 0.2 / std::f64::consts::TAU;
    let names = [
        ("q_rail", "q_rail", 1.0),
        ("phi", "q_swing", 1.0),
        ("q_thread", "q_q_thread_follower", advance),
        ("q_bush_1", "q_q_bush_1", 1.0),
        ("q_bush_2", "q_q_bush_2", 1.0),
        ("q_shoulder_1", "q_q_shoulder_1", 1.0),
        ("q_shoulder_2", "q_q_shoulder_2", 1.0),
        ("q_shoulder_3", "q_q_shoulder_3", 1.0),
        ("q_floor_1", "q_floor_1", 1.0),
        ("q_floor_2", "q_floor_2", 1.0),
        ("q_floor_3", "q_floor_3", 1.0),
    ];
    assert_same_robot(folder.path(), "kinds.toml", &names);
}

/// Two carts whose positions are measured from the ground, and a body in a plane whose angle a wheel follows.
const CARTS: &str = r#"name = "carts"
[parameters]
g = "9.81 m/s^2"
m = "2 kg"
A = "0.05 kg*m^2"
h = "0.1 m"
d = "0.2 m"
[coordinates]
x1 = { unit = "m" }
x2 = { unit = "m" }
x = { unit = "m" }
y = { unit = "m" }
theta = { unit = "rad" }
[speeds]
u1 = "x1'"
u2 = "x2'"
u3 = "x'"
u4 = "y'"
u5 = "theta'"
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
[frames]
B = { from = "N", axis = 3, angle = "theta" }
W = { from = "B", axis = 1, angle = "2*theta" }
[points]
P = { from = "O", frame = "N", position = ["x1", 0, 0] }
Q = { from = "P", frame = "N", position = ["x2 - x1", 0, "h"] }
C = { from = "O", frame = "N", position = ["x", "y", 0] }
D = { from = "C", frame = "B", position = ["d", 0, 0] }
[particles]
first = { point = "P", mass = "m" }
second = { point = "Q", mass = "m/2" }
[bodies]
plate = { frame = "B", centre = "C", mass = "m", inertia = { diagonal = ["A", "A", "A"] } }
wheel = { frame = "W", centre = "D", mass = "m/4", inertia = { diagonal = ["A", "A", "A"] } }
"#;

/// Goal: parts of a position that cancel make no joint, and no joint follows one with several coordinates.
#[test]
fn cancelled_parts_and_followed_angles_keep_their_coordinates() {
    let (folder, text) = folder_with("carts.toml", CARTS);
    assert!(!text.contains("NaN"), "{text}");
    let names = [("x1", "q_x1", 1.0), ("x2", "q_x2", 1.0), ("x", "q_x", 1.0), ("y", "q_y", 1.0)];
    let names = [&names[..], &[("theta", "q_theta", 1.0)]].concat();
    assert_same_robot(folder.path(), "carts.toml", &names);
}

/// A model of one arm; words of it are replaced by mistakes.
pub const ARM: &str = r#"name = "arm"
[parameters]
g = "1.62 m/s^2"
m = "2 kg"
l = "0.3 m"
A = { unit = "kg*m^2", value = 0.05 }
[coordinates]
q = { unit = "rad" }
p = { unit = "rad" }
[speeds]
u = "q'"
v = "p'"
[inertial]
frame = "N"
origin = "O"
[frames]
F = { from = "N", axis = 3, angle = "q" }
G = { from = "F", axis = 1, angle = "p" }
[points]
C = { from = "O", frame = "F", position = ["l", 0, 0] }
D = { from = "C", frame = "G", position = [0, 0, "l"] }
[bodies]
upper = { frame = "F", centre = "C", mass = "m", inertia = { diagonal = ["A", "A", "A"] } }
lower = { frame = "G", centre = "D", mass = "m", inertia = { diagonal = ["A", "A", "A"] } }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#;

/// Goal: people read the file. Method: a snapshot of the file, which is left alone if nothing changes, and of the JSON.
#[test]
fn an_arm_becomes_a_readable_description() {
    let (folder, text) = folder_with("arm.toml", ARM);
    expect![[r#"
        <!-- Generated from `arm.toml`. Do not edit; run `tripos emit`. -->
        <!-- Left out: gravity (0, 0, -1.62) m/s²: readers of URDF take (0, 0, -9.81) m/s²; set it in their program. -->
        <robot name="arm">
          <link name="world"/>
          <joint name="q" type="continuous">
            <parent link="world"/>
            <child link="upper"/>
            <origin xyz="0 0 0"/>
            <axis xyz="0 0 1"/>
          </joint>
          <link name="upper">
            <inertial>
              <origin xyz="0.3 0 0"/>
              <mass value="2"/>
              <inertia ixx="0.05" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.05"/>
            </inertial>
          </link>
          <joint name="p" type="continuous">
            <parent link="upper"/>
            <child link="lower"/>
            <origin xyz="0.3 0 0"/>
            <axis xyz="1 0 0"/>
          </joint>
          <link name="lower">
            <inertial>
              <origin xyz="0 0 0.3"/>
              <mass value="2"/>
              <inertia ixx="0.05" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.05"/>
            </inertial>
          </link>
        </robot>
    "#]]
    .assert_eq(&text);
    let arguments = ["emit", "arm.toml", "--language", "urdf", "--out", "written", "--json"];
    expect![[r#"
        {
          "schema": 1,
          "folder": "written",
          "files": [
            {
              "file": "arm.urdf",
              "change": "unchanged"
            }
          ],
          "left_out": [
            {
              "what": "gravity (0, 0, -1.62) m/s²: readers of URDF take (0, 0, -9.81) m/s²; set it in their program"
            }
          ],
          "use": "each coordinate of the model belongs to one joint, with the same zero and sign; parameters have their default values"
        }
    "#]].assert_eq(&tripos(folder.path(), &arguments).0);
}

/// Goal: bodies on one axis that misses itself by rounding are moved by one joint. Method: two bodies on a frame, one
/// of them from a point 0.1 m + 0.2 m − 0.3 m beside the axis, which is 5.6e-17 m in doubles.
#[test]
fn places_that_differ_by_rounding_have_one_joint() {
    let model = r#"
name = "two parts on one hinge"
[inertial]
frame = "N"
origin = "O"
[parameters]
m = "1 kg"
J = "0.01 kg*m^2"
l = "0.5 m"
a = "0.1 m"
b = "0.2 m"
c = "0.3 m"
[coordinates]
q = { unit = "rad" }
[speeds]
u = "q'"
[frames]
B = { from = "N", axis = 3, angle = "q" }
[points]
H = { from = "O", frame = "N", position = ["a + b - c", 0, 0] }
P = { from = "O", frame = "B", position = ["l", 0, 0] }
Q = { from = "H", frame = "B", position = [0, "l", 0] }
[bodies]
one = { frame = "B", centre = "P", mass = "m", inertia = "J" }
two = { frame = "B", centre = "Q", mass = "m", inertia = "J" }
"#;
    let (_folder, description) = folder_with("near.toml", model);
    assert_eq!(
        description.matches("<joint name=").count() - description.matches("type=\"fixed\"").count(),
        1,
        "{description}"
    );
    assert!(!description.contains("<mimic"), "{description}");
}
