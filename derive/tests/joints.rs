//! Joints, repetition, named expressions and numbers with units: their meaning, and the messages for wrong ones.
//!
//! `UPDATE_EXPECT=1 cargo test` accepts new words; read them before you commit them.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::common;

use common::{errors, read};
use expect_test::{Expect, expect};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::mechanics::{Formulation, derive_all};
use tripos_derive::model::Model;

const WORLD: &str = "name = \"joints\"\n[parameters]\nl = { unit = \"m\", value = 1, positive = true }\nm = { unit = \"kg\", value = 1, \
                     positive = true }\nI = { unit = \"kg*m^2\", value = 1, positive = true }\ng = \"9.81 m/s^2\"\n[inertial]\nframe = \
                     \"N\"\norigin = \"O\"\n[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n";

fn model(rest: &str) -> Model {
    read(&format!("{WORLD}{rest}")).unwrap_or_else(|e| panic!("{e}"))
}

fn check(rest: &str, expected: &Expect) {
    let lines: Vec<String> =
        errors(&format!("{WORLD}{rest}")).to_string().lines().map(|l| l.trim_end().to_owned()).collect();
    expected.assert_eq(&lines.join("\n"));
}

/// M and f of Kane's equations, as text.
fn kane(model: &Model) -> (Vec<Vec<String>>, Vec<String>) {
    let derivations = derive_all(model).unwrap();
    let arena = &derivations.kinematics.arena;
    let show = |e: &tripos_derive::algebra::Expr| print_text(arena, *e);
    let equations = derivations.get(Formulation::Kane).unwrap();
    (
        equations.matrix.iter().map(|row| row.iter().map(show).collect()).collect(),
        equations.forcing.iter().map(show).collect(),
    )
}

/// Goal: joints are frames, points, coordinates and speeds. Method: a double pendulum by joints and written out has the
/// same equations, character by character.
#[test]
fn a_chain_by_joints_is_the_chain_written_out() {
    let by_joints = model(
        "[counts]\nn = 3\n[bodies.\"rod{i in 1..n}\"]\nmass = \"m\"\ninertia = \"I\"\n[joints.pin1]\nkind = \"pin\"\nbody = \
         \"rod1\"\ncentre = [\"l/2\", 0, 0]\n[joints.\"pin{i in 2..n}\"]\nkind = \"pin\"\nbody = \"rod{i}\"\nto = \"rod{i-1}\"\nat = \
         [\"l\", 0, 0]\ncentre = [\"l/2\", 0, 0]\n",
    );
    let mut written = "[coordinates]\n".to_owned();
    let each = |line: &str| {
        (1..=3).map(|i| line.replace('#', &i.to_string()).replace('%', &(i - 1).to_string())).collect::<String>()
    };
    written += &each("q_pin# = { unit = \"rad\" }\n");
    written += "[speeds]\n";
    written += &each("u_pin# = \"q_pin#'\"\n");
    let frames = each("F# = { from = \"F%\", axis = 3, angle = \"q_pin#\" }\n").replace("F0", "N");
    let points = each("P# = { from = \"P%\", frame = \"F#\", position = [\"l\", 0, 0] }\n").replace("P0", "O");
    let centres = each("C# = { from = \"P%\", frame = \"F#\", position = [\"l/2\", 0, 0] }\n").replace("P0", "O");
    written += &["[frames]\n", &frames, "[points]\n", &points, &centres].concat();
    written += &each(
        "[bodies.rod#]\nframe = \"F#\"\ncentre = \"C#\"\nmass = \"m\"\ninertia = { diagonal = [\"I/2\", \"I/2\", \"I\"] }\n",
    );
    assert_eq!(kane(&by_joints), kane(&model(&written)));
}

/// Goal: what stands behind each kind. Method: its coordinates, their units, and the speeds that determine them.
#[test]
fn each_kind_has_its_freedoms() {
    let kinds = [
        ("pin", vec!["q_j"]),
        ("slider", vec!["q_j"]),
        ("cylinder", vec!["q_j_1", "q_j_2"]),
        ("universal", vec!["q_j_1", "q_j_2"]),
        ("ball", vec!["q_j_1", "q_j_2", "q_j_3"]),
        ("planar", vec!["q_j_1", "q_j_2", "q_j_3"]),
        ("free", vec!["q_j_1", "q_j_2", "q_j_3", "q_j_4", "q_j_5", "q_j_6"]),
    ];
    for (kind, coordinates) in kinds {
        let model = model(&format!(
            "[bodies]\nb = {{ mass = \"m\", inertia = {{ diagonal = [\"I\", \"I\", \"I\"] }} }}\n[joints]\nj = {{ kind = \
             \"{kind}\", body = \"b\", centre = [\"l\", 0, 0] }}\n"
        ));
        let names: Vec<&str> = model.coordinates.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, coordinates, "{kind}");
        assert_eq!(model.speeds.len(), coordinates.len(), "{kind}");
        assert!(model.unused.iter().all(|(what, _)| *what == "parameter"), "{kind}: {:?}", model.unused);
    }
    let welded = model(
        "[bodies]\na = { mass = \"m\", inertia = \"I\" }\nb = { mass = \"m\", inertia = \"I\" }\n[joints]\nj = { kind = \"pin\", \
         body = \"a\" }\nk = { kind = \"weld\", body = \"b\", to = \"a\", at = [\"l\", 0, 0] }\n",
    );
    let (matrix, _) = kane(&welded);
    assert_eq!(matrix, [["l^2*m + 2*I"]]);
}

#[test]
fn a_screw_advances_by_its_lead() {
    let screw = model(
        "[bodies]\nb = { mass = \"m\", inertia = { diagonal = [\"I\", \"I\", \"I\"] } }\n[joints]\nj = { kind = \"screw\", body = \
         \"b\", lead = \"l\", axis = 2 }\n",
    );
    let (matrix, forcing) = kane(&screw);
    assert_eq!(matrix, [["l^2*m/(4*pi^2) + I"]]);
    assert_eq!(forcing, ["-l*m*g/(2*pi)"]);
}

/// Goal: the independent speeds that constraints leave are found; speeds of joints are left out. Method: a
/// parallelogram closed by a pin keeps one of its three.
#[test]
fn a_closed_chain_keeps_the_speeds_that_are_independent() {
    let links = "[bodies]\na = { mass = \"m\", inertia = \"I\" }\nb = { mass = \"m\", inertia = \"I\" }\nc = { mass = \"m\", inertia = \
                 \"I\" }\n[joints]\nja = { kind = \"pin\", body = \"a\" }\njb = { kind = \"pin\", body = \"b\", to = \"a\", at = \
                 [\"l\", 0, 0] }\njc = { kind = \"pin\", body = \"c\", to = \"b\", at = [\"2*l\", 0, 0] }\n";
    let closed = model(&format!(
        "{links}jd = {{ kind = \"pin\", body = \"c\", at = [\"l\", 0, 0], body_at = [\"l\", 0, 0] }}\n"
    ));
    let speeds: Vec<&str> = closed.speeds.iter().map(|s| s.name.as_str()).collect();
    assert_eq!(speeds, ["u_ja"]);
    assert_eq!(closed.loops.iter().map(|l| l.name.as_str()).collect::<Vec<_>>(), ["jd_1", "jd_2"]);
    let repeated: Vec<(&str, bool)> = closed.repeated.iter().map(|r| (r.name.as_str(), r.is_of_loop)).collect();
    assert_eq!(repeated, [("jd_3", true), ("jd_turn31", true), ("jd_turn32", true)]);
    let chosen = links
        .replace("body = \"c\", to", "body = \"c\", speeds = [], to")
        .replace("kind = \"pin\", body = \"a\"", "kind = \"pin\", body = \"a\", speeds = []");
    let chosen = model(&format!(
        "{chosen}jd = {{ kind = \"pin\", body = \"c\", at = [\"l\", 0, 0], body_at = [\"l\", 0, 0] }}\n"
    ));
    assert_eq!(chosen.speeds.iter().map(|s| s.name.as_str()).collect::<Vec<_>>(), ["u_jb"]);
}

#[test]
fn numbers_with_units_are_values() {
    let model = model(
        "[counts]\nn = 2\n[expressions]\narm = \"l*m\"\nmore = { value = \"arm*l\" }\n[bodies]\nb = { mass = \"m\", inertia = \"more\" \
         }\n[joints]\n\"j{n-1}\" = { kind = \"pin\", body = \"b\" }\n[torques.motor]\non = \"b\"\nframe = \"N\"\nvector = [0, 0, \
         \"-g*max(arm, m*l, 2*arm)\"]\n",
    );
    let (matrix, forcing) = kane(&model);
    assert_eq!((matrix, forcing), (vec![vec!["l^2*m".to_owned()]], vec!["-g*(3*l*m + abs(l*m))/2".to_owned()]));
    let g = model.parameters.iter().find(|p| p.name == "g").unwrap();
    assert_eq!((g.unit.to_string(), g.value.as_ref().unwrap().to_f64()), ("m/s^2".to_owned(), 9.81));
}

#[test]
fn joints_that_cannot_be() {
    check(
        "[bodies]\nb = { mass = \"m\", inertia = \"I\" }\nd = { mass = \"m\", inertia = \"I\" }\n[joints]\nj = { kind = \"hinge\", body = \"b\" }\nk = { kind = \"pin\", body = \
         \"c\" }\nw = { kind = \"screw\", body = \"d\" }\n",
        &expect![[r#"
            error: there is no joint of the kind `hinge`
              --> model.toml:17:15
               |
            17 | j = { kind = "hinge", body = "b" }
               |               ^^^^^
               |
               = help: known here: `pin`, `slider`, `cylinder`, `screw`, `universal`, `ball`, `planar`, `weld`, `free`

            error: there is no rigid body `c`
              --> model.toml:18:29
               |
            18 | k = { kind = "pin", body = "c" }
               |                             ^
               |
               = help: known here: `b`, `d`

            error: joint `w` has no `lead`
              --> model.toml:19:1
               |
            19 | w = { kind = "screw", body = "d" }
               | ^
               |
               = help: add `lead = …`"#]],
    );
    check(
        "[bodies]\na = { mass = \"m\", inertia = \"I\" }\nb = { mass = \"m\", inertia = \"I\" }\n[joints]\nj = { kind = \"pin\", body = \
         \"a\", to = \"b\" }\nk = { kind = \"pin\", body = \"b\", to = \"a\" }\n",
        &expect![[r#"
            error: `a_frame` is placed from itself: a_frame -> b_frame -> a_frame
              --> model.toml:17:39
               |
            17 | j = { kind = "pin", body = "a", to = "b" }
               |                                       ^
               |
               = help: every frame and point must lead back to the inertial frame and the origin"#]],
    );
    check(
        "[bodies]\nb = { mass = \"m\", inertia = \"I\" }\n[joints]\nj = { kind = \"ball\", body = \"b\", sequence = \"113\" }\nk = { kind \
         = \"pin\", body = \"b\", coordinates = [\"a\", \"b\"] }\n",
        &expect![[r#"
            error: `113` is not a sequence of turns
              --> model.toml:16:46
               |
            16 | j = { kind = "ball", body = "b", sequence = "113" }
               |                                              ^^^
               |
               = help: write the axes of the turns one after the other, such as "313"; neighbours differ

            error: unknown key `coordinates` in a joint that closes a loop
              --> model.toml:17:33
               |
            17 | k = { kind = "pin", body = "b", coordinates = ["a", "b"] }
               |                                 ^^^^^^^^^^^
               |
               = help: known here: `kind`, `body`, `to`, `at`, `turned`, `about`, `body_at`, `body_turned`, `axis`"#]],
    );
    check(
        "[bodies]\nb = { mass = \"m\", inertia = \"I\" }\n[joints]\nj = { kind = \"ball\", body = \"b\" }\n",
        &expect![[r#"
            error: a body that turns about several axes has more than one moment of inertia
              --> model.toml:14:29
               |
            14 | b = { mass = "m", inertia = "I" }
               |                             ^^^
               |
               = help: state its three moments: inertia = { diagonal = ["I1", "I2", "I3"] }"#]],
    );
    check(
        "[bodies]\nb = { mass = \"m\", inertia = \"I\" }\n[joints]\nj = { kind = \"pin\", body = \"b\" }\nk = { kind = \"free\", body = \
         \"b\" }\n",
        &expect![[r#"
            error: joint `k` cannot close a loop: `b` is placed already
              --> model.toml:17:15
               |
            17 | k = { kind = "free", body = "b" }
               |               ^^^^
               |
               = help: leave the other place of the body out, or state the tie under [constraints]"#]],
    );
}

#[test]
fn one_error_of_a_joint_is_one_error() {
    let b = "[bodies]\nb = { mass = \"m\", inertia = \"I\" }\n[joints]\n";
    for (joint, message) in [
        ("axis = 4", "the axis of a rotation is 1, 2 or 3"),
        ("at = [\"l\", 0]", "`at` has 2 components, not 3"),
        ("to = \"N\"", "there is no rigid body `N`"),
        ("speeds = []", "the model has no speeds"),
        ("turned = 3", "`turned` of joint `j` must be a table"),
        ("axle = 3", "unknown key `axle` in joint `j`"),
        ("coordinates = [\"a\", \"c\"]", "joint `j` names 2 coordinates, but has 1"),
    ] {
        let errors = errors(&format!("{WORLD}{b}j = {{ kind = \"pin\", body = \"b\", {joint} }}\n")).to_string();
        assert!(errors.contains(message) && errors.matches("error: ").count() == 1, "{joint}: {errors}");
    }
}

#[test]
fn repetition_that_cannot_be() {
    check(
        "[bodies]\n\"b{i in 1..n}\" = { mass = \"m\", inertia = \"I\" }\n[joints]\n\"j{i in 1..2}\" = { kind = \"pin\", body = \"b{k}\" }\n",
        &expect![[r#"
            error: `{n}`: `n` is no index and no count
              --> model.toml:14:1
               |
            14 | "b{i in 1..n}" = { mass = "m", inertia = "I" }
               | ^^^^^^^^^^^^^^
               |
               = help: write an index as {i} or {i-1}, a range as {i in 1..4}; counts stand under [counts]

            error: `{k}`: `k` is no index and no count
              --> model.toml:16:41
               |
            16 | "j{i in 1..2}" = { kind = "pin", body = "b{k}" }
               |                                         ^^^^^^
               |
               = help: write an index as {i} or {i-1}, a range as {i in 1..4}; counts stand under [counts]"#]],
    );
    check(
        "[counts]\nn = 2.5\n[bodies]\n\"b{i in 1..4\" = { mass = \"m\", inertia = \"I\" }\n",
        &expect![[r#"
        error: the count `n` is not a whole number up to 1000000
          --> model.toml:14:5
           |
        14 | n = 2.5
           |     ^^^
           |
           = help: write n = 10

        error: this `{` is never closed
          --> model.toml:16:1
           |
        16 | "b{i in 1..4" = { mass = "m", inertia = "I" }
           | ^^^^^^^^^^^^^
           |
           = help: write a range as {i in 1..4}"#]],
    );
    check(
        "[bodies]\n\"b{i in 1..1000000}\" = { mass = \"m\", inertia = \"I\" }\n",
        &expect![[r#"
        error: the range 1..1000000 has more than 20000 numbers
          --> model.toml:14:1
           |
        14 | "b{i in 1..1000000}" = { mass = "m", inertia = "I" }
           | ^^^^^^^^^^^^^^^^^^^^
           |
           = help: state a smaller mechanism"#]],
    );
}

#[test]
fn expressions_that_cannot_be() {
    check(
        "[expressions]\nw = \"u*l\"\nv = \"w + m\"\n[bodies]\nb = { mass = \"w\", inertia = \"I\" }\n[joints]\nj = { kind = \"pin\", body = \
         \"b\", coordinates = [\"q\"], speeds = [\"u\"] }\n",
        &expect![[r#"
            error: `m` is in kg but `l*u` in m/s: they cannot be added
              --> model.toml:15:6
               |
            15 | v = "w + m"
               |      ^^^^^
               |
               = help: check the units of the parameters and coordinates

            error: the speed `u` cannot stand in the mass of body `b`: it is in `w`
              --> model.toml:17:15
               |
            17 | b = { mass = "w", inertia = "I" }
               |               ^
               |
               = help: allowed: parameters"#]],
    );
}

#[test]
fn units_that_do_not_fit() {
    check(
        "[bodies]\nb = { mass = \"2 m\", inertia = \"I\" }\n[joints]\nj = { kind = \"pin\", body = \"b\", turned = { sequence = \"3\", \
         angles = [\"3 m\"] } }\n",
        &expect![[r#"
            error: the mass of body `b` must be in kg, but `2 m` is in m
              --> model.toml:14:15
               |
            14 | b = { mass = "2 m", inertia = "I" }
               |               ^^^
               |
               = help: state it in kg

            error: an angle must be in 1 or rad, but `3 m` is in m
              --> model.toml:16:71
               |
            16 | j = { kind = "pin", body = "b", turned = { sequence = "3", angles = ["3 m"] } }
               |                                                                       ^^^
               |
               = help: state it in rad or deg"#]],
    );
}

/// A scotch yoke: a crank whose pin runs in the slot of what slides.
fn yoke(axis: &str) -> Model {
    model(&format!(
        "[bodies]\ncrank = {{ mass = \"m\", inertia = \"I\" }}\nyoke = {{ mass = \"m\", inertia = \"I\" }}\n[joints]\nA = {{ kind = \"pin\", body = \
         \"crank\", coordinates = [\"q\"], speeds = [\"u\"] }}\nB = {{ kind = \"slider\", body = \"yoke\", axis = {axis}, coordinates = [\"x\"], speeds = [] \
         }}\n[constraints]\nslot = {{ equation = \"x = l*cos(q)\" }}\n"
    ))
}

/// Goal: the frame of a joint along the first or second axis only exchanges axes, so a small mechanism keeps its closed
/// form without named terms. Method: a scotch yoke, whose equation is (I + m l² sin² q) u' = −m l² u² sin q cos q.
#[test]
fn a_slider_along_any_axis_leaves_small_equations_in_closed_form() {
    for axis in ["1", "[1, 0, 0]", "[-1, 0, 0]"] {
        let (matrix, forcing) = kane(&yoke(axis));
        assert_eq!(matrix, [["I + l^2*m*sin(q)^2"]], "{axis}");
        assert_eq!(forcing, ["-l^2*m*u^2*sin(q)*cos(q)"], "{axis}");
    }
}

/// Goal: a body with Euler parameters starts in any attitude. Method: random unit quaternions with all speeds stated;
/// the rates of four of a hundred were called impossible, since the singular values of their matrix are equal.
#[test]
fn a_free_body_starts_in_any_attitude() {
    let mut model = model(
        "[bodies]\nb = { mass = \"m\", inertia = { diagonal = [\"I\", \"I\", \"I\"] } }\nc = { mass = \"m\", inertia = { diagonal = [\"I\", \"I\", \"I\"] } }\n[joints]\n\
         f = { kind = \"free\", sequence = \"euler\", body = \"b\" }\np = { kind = \"pin\", body = \"c\", to = \"b\" }\n",
    );
    let mut seed = 1_u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for _ in 0..200 {
        let parts: [f64; 4] = std::array::from_fn(|_| draw());
        let size = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
        let attitude = (4..).zip(&parts).map(|(at, part)| format!("q_f_{at} = {}\n", part / size));
        let speeds = (1..=6).map(|at| format!("u_f_{at} = {}\n", 3.0 * draw()));
        let stated: Vec<String> = attitude.chain(speeds).collect();
        let stated = stated.concat();
        let text = format!(
            "model = \"model.toml\"\nspan = [0, 1]\n[start]\nq_f_1 = 0\nq_f_2 = 0\nq_f_3 = 0\nq_p = 0.3\nu_p = 1\n{stated}"
        );
        let source = tripos_derive::diagnostic::Source::from_text("scene.toml", &text);
        if let Err(errors) = tripos_derive::scene::load(&source, &mut model) {
            panic!("{text}{errors}");
        }
    }
}
