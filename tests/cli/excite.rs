//! Motions that tell base parameters: `tripos excite`.
//!
//! Truth: limits that the test states, the fits of `tripos fit`, and plain sines with the same limits.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::support::{root, tripos_in};
use expect_test::{Expect, expect};
use serde_json::Value;
use std::f64::consts::TAU;
use std::path::Path;

/// Limits of the arm: its angles, the rate of the first joint, and the second rates.
const LIMITS: [&str; 10] =
    ["--limit", "q1=-1.2:1.2", "--limit", "q2=-1.5:1.5", "--limit", "u1=3", "--limit", "q1''=12", "--limit", "u2'=12"];
/// Noise of the torques, N m.
const NOISE: [f64; 2] = [0.05, 0.02];

/// Folder with the model of the arm.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(root().join("tests/data/fit/arm.toml"), folder.path().join("arm.toml")).unwrap();
    folder
}

/// Result of a command as JSON.
fn json(folder: &Path, arguments: &[&str]) -> Value {
    let (status, out, err) = tripos_in(folder, &[arguments, &["--json"]].concat());
    assert_eq!(status, 0, "{out}{err}");
    serde_json::from_str(&out).unwrap_or_else(|_| panic!("{out}{err}"))
}

/// Makes measurements of a motion: the torques that it needs, with seeded noise, as `measured.csv`. Returns the
/// standard errors of a fit to them.
fn errors_of_fit(folder: &Path, motion: &str) -> Vec<f64> {
    let (status, out, err) = tripos_in(folder, &["inverse", "arm.toml", "--motion", motion, "--csv"]);
    assert_eq!(status, 0, "{err}");
    let mut random = crate::spoilt::Random(3);
    let mut lines = out.lines();
    let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
    let kept: Vec<usize> = (0..heads.len()).filter(|at| !heads[*at].starts_with("force")).collect();
    let line = |cells: Vec<String>| cells.join(",") + "\n";
    let mut table = line(kept.iter().map(|at| heads[*at].to_owned()).collect());
    for row in lines {
        let cells: Vec<&str> = row.split(',').collect();
        let cell = |at: &usize| {
            let noise = ["tau1", "tau2"].iter().position(|name| *name == heads[*at]).map_or(0.0, |at| NOISE[at]);
            (cells[*at].parse::<f64>().unwrap() + noise * random.between(-1.7, 1.7)).to_string()
        };
        table += &line(kept.iter().map(cell).collect());
    }
    std::fs::write(folder.join("measured.csv"), table).unwrap();
    let noise = [format!("force(u1)={}", NOISE[0]), format!("force(u2)={}", NOISE[1])];
    let found =
        json(folder, &["fit", "arm.toml", "--data", "measured.csv", "--noise", &noise[0], "--noise", &noise[1]]);
    let of = |estimate: &Value| {
        let (value, stated, error) = (&estimate["value"], &estimate["stated"], estimate["error"].as_f64().unwrap());
        assert!((value.as_f64().unwrap() - stated.as_f64().unwrap()).abs() < 4.0 * error, "{estimate}");
        error
    };
    found["estimates"].as_array().unwrap().iter().map(of).collect()
}

/// Table of plain sines of both joints that touch their limits, with this number of periods in 10 s.
fn sines(periods: f64) -> String {
    let mut table = "t,q1,q2,u1,u2,u1',u2'\n".to_owned();
    let w = TAU * periods / 10.0;
    let size = [1.2_f64.min(3.0 / w).min(12.0 / w.powi(2)), 1.5_f64.min(12.0 / w.powi(2))];
    for k in 0..=100 {
        let t = 0.1 * f64::from(k);
        let of = |joint: usize, order: usize| {
            let (sin, cos) = (w * t).sin_cos();
            size[joint] * [sin, w * cos, -w.powi(2) * sin][order]
        };
        let cells: Vec<String> = (0..6).map(|at| of(at % 2, at / 2).to_string()).collect();
        table += &[&[t.to_string()], &cells[..]].concat().join(",");
        table.push('\n');
    }
    table
}

/// Goal: a designed motion gives smaller standard errors than plain sines, and predicts them. Method: the motion is
/// written, its torques are made, and they are fitted.
#[test]
fn the_written_motion_is_fitted_with_small_errors() {
    let folder = folder();
    let noise = ["--noise", "force(u1)=0.05", "--noise", "force(u2)=0.02", "--write"];
    let excite = [&["excite", "arm.toml"], &LIMITS[..], &noise[..]].concat();
    let found = json(folder.path(), &[&excite[..], &["motion.csv"]].concat());
    let errors = errors_of_fit(folder.path(), "motion.csv");
    let base = found["base"].as_array().unwrap();
    assert_eq!(base.len(), errors.len());
    for (base, error) in base.iter().zip(&errors) {
        let predicted = base["error"].as_f64().unwrap();
        assert!((predicted / error - 1.0).abs() < 1e-6, "{base}: {error} in the fit");
    }
    for periods in [1.0, 2.0, 3.0] {
        std::fs::write(folder.path().join("sine.csv"), sines(periods)).unwrap();
        let others = errors_of_fit(folder.path(), "sine.csv");
        assert!(others.iter().zip(&errors).all(|(other, own)| other > own), "{periods}: {others:?}, not {errors:?}");
    }

    // The formulas are the same motion.
    let (status, out, err) = tripos_in(folder.path(), &[&excite[..], &["motion.toml"]].concat());
    assert_eq!(status, 0, "{err}");
    let formulas = std::fs::read_to_string(folder.path().join("motion.toml")).unwrap();
    assert!(out.contains(&formulas), "{out}");
    let needed = |motion: &str| json(folder.path(), &["inverse", "arm.toml", "--motion", motion]);
    let (table, formulas) = (needed("motion.csv"), needed("motion.toml"));
    let of = |needs: &Value| needs["motion"].as_array().unwrap().clone();
    assert_eq!(of(&table).len(), 101);
    for (one, other) in of(&table).iter().zip(&of(&formulas)) {
        for force in ["u1", "u2"] {
            let [one, other] = [one, other].map(|instant| instant["forces"][force].as_f64().unwrap());
            assert!((one - other).abs() < 1e-10, "{one} and {other}");
        }
    }
}

/// Goal: the text says what a reader needs. Method: the lines without numbers, for an arm of which one joint is held.
#[test]
fn the_text_names_limits_and_what_is_not_told() {
    let folder = folder();
    let arguments = ["excite", "arm.toml", "--limit", "q1=0.5:0.5", "--limit", "q2=1", "--starts", "1"];
    let (status, out, err) = tripos_in(folder.path(), &arguments);
    assert_eq!(status, 1, "{out}{err}");
    let is_number = |word: &str| word.trim_end_matches(',').parse::<f64>().is_ok();
    let words = |line: &str| {
        let words = line.split(' ').map(|word| if is_number(word) { "#" } else { word });
        words.collect::<Vec<_>>().join(" ")
    };
    let lines: Vec<String> = out.lines().filter(|line| !line.starts_with("q2 =")).map(words).collect();
    expect![[r#"
        Arm of two links: a motion that determines its base parameters
        best of # motions in # searches; a better one may exist

        [motion]
        q1 = "0.5"
        [times]
        from = #
        to = #
        count = #

        extreme values at all instants, and limits, in SI units
          q1: # to # limits # to #
          q1': # to # no limit
          q1'': # to # no limit
          q2: # to # limits # to #
          q2': # to # no limit
          q2'': # to # no limit

        regressor W of # forces: rank # of # base parameters
        log det of W' S^-1 W = # S the covariance of the forces, SI units, of # independent columns
        condition number of W with columns of length 1: #

        standard errors of the base parameters from forces of standard deviation #
          Izz_upper + L1^2*m_fore: not determined by the motion
          Izz_fore: # kg*m^2
          mx_fore: # kg*m
          my_fore: # kg*m
          d1: not determined by the motion
        not determined by the motion: no force changes if Izz_upper + L1^2*m_fore changes by #
        not determined by the motion: no force changes if d1 changes by #
    "#]]
    .assert_eq(&(lines.join("\n") + "\n"));
}

/// Checks the error of a design in a folder.
#[expect(clippy::needless_pass_by_value, reason = "expect! makes values")]
fn refuses(folder: &Path, arguments: &[&str], expected: Expect) {
    let (status, out, err) = tripos_in(folder, &[&["excite"], arguments].concat());
    assert_eq!(status, 2, "{out}{err}");
    expected.assert_eq(&err);
}

/// Checks the error of a design for the arm.
fn refuses_for_arm(arguments: &[&str], expected: Expect) {
    refuses(folder().path(), &[&["arm.toml"], arguments].concat(), expected);
}

/// Arguments with good limits of both joints, and further ones.
fn with_limits(more: &[&'static str]) -> Vec<&'static str> {
    [&["--limit", "q1=1", "--limit", "q2=1"], more].concat()
}

/// Goal: wrong limits get an error with its reason and a hint. Method: one of each kind.
#[test]
fn wrong_limits_are_refused() {
    refuses_for_arm(
        &["--limit", "q1=1"],
        expect![[r#"
        error: the coordinate `q2` has no limits
        help: state them, as in `--limit q2=-1:1`, or in [domain] of the model
    "#]],
    );
    refuses_for_arm(
        &["--limit", "q1=1", "--limit", "q2=:1"],
        expect![[r#"
        error: the coordinate `q2` has no lower limit
        help: state them, as in `--limit q2=-1:1`, or in [domain] of the model
    "#]],
    );
    refuses_for_arm(
        &["--limit", "q1=2:1"],
        expect![[r#"
        error: the limits of `--limit q1=2:1` exclude one another: 2 is above 1
        help: give the lower limit first, and a largest size that is not negative
    "#]],
    );
    refuses_for_arm(
        &["--limit", "q1=-1"],
        expect![[r#"
        error: the limits of `--limit q1=-1` exclude one another: 1 is above -1
        help: give the lower limit first, and a largest size that is not negative
    "#]],
    );
    refuses_for_arm(
        &["--limit", "q1"],
        expect![[r#"
        error: `--limit q1` is not understood
        help: write --limit NAME=LOW:HIGH or NAME=MAX, such as q1=-1:1 or "q1'=2"
    "#]],
    );
    refuses_for_arm(
        &["--limit", "q1=wide"],
        expect![[r#"
        error: `wide` in `--limit` is no number
        help: give a number in SI units
    "#]],
    );
    refuses_for_arm(
        &["--limit", "q1=0:0", "--limit", "q2=0:0"],
        expect![[r#"
            error: no motion within the limits determines a base parameter
            help: give at least one coordinate limits that let it move
        "#]],
    );
    refuses_for_arm(
        &with_limits(&["--limit", "q1=2"]),
        expect![[r#"
        error: `--limit` names `q1` twice
        help: leave one of them out
    "#]],
    );
    refuses_for_arm(
        &with_limits(&["--limit", "q3=1"]),
        expect![[r#"
        error: there is no coordinate, speed or rate `q3` to limit
        help: did you mean `q1`?
    "#]],
    );
    refuses_for_arm(
        &with_limits(&["--limit", "u1=1:2"]),
        expect![[r#"
        error: the limits of `q1'` from 1 to 2 leave no room: a periodic motion needs both signs
        help: give a range that contains 0, as in `--limit "q1'=2"`
    "#]],
    );
}

/// Goal: wrong options get an error with its reason and a hint. Method: one of each kind.
#[test]
fn wrong_options_are_refused() {
    refuses_for_arm(
        &with_limits(&["--home", "q1=1.5"]),
        expect![[r#"
        error: the start of `q1` at 1.5 is not between its limits -1 and 1
        help: give a start between the limits, or other limits
    "#]],
    );
    refuses_for_arm(
        &with_limits(&["--home", "q=0"]),
        expect![[r#"
        error: there is no coordinate `q` to start from
        help: did you mean `q1`?
    "#]],
    );
    refuses_for_arm(
        &with_limits(&["--noise", "force(q1)=1"]),
        expect![[r#"
        error: there is no force `force(q1)`
        help: did you mean `force(u1)`?
    "#]],
    );
    refuses_for_arm(
        &with_limits(&["--noise", "force(u1)=0"]),
        expect![[r#"
        error: the standard deviation `0` in `--noise` is not above 0
        help: give a number above 0
    "#]],
    );
    refuses_for_arm(
        &with_limits(&["--period", "-1"]),
        expect![[r#"
            error: the period -1 s is not above 0
            help: give a period above 0 s
        "#]],
    );
    refuses_for_arm(
        &with_limits(&["--harmonics", "1", "--rest"]),
        expect![[r#"
            error: 1 harmonics are not possible
            help: give from 2 to 50 harmonics for a motion that starts at rest
        "#]],
    );
    refuses_for_arm(
        &with_limits(&["--samples", "8"]),
        expect![[r#"
            error: 8 samples are not possible for 5 harmonics
            help: give from 12 to 10000 samples
        "#]],
    );
    refuses_for_arm(
        &with_limits(&["--starts", "0"]),
        expect![[r#"
        error: 0 searches are not possible
        help: give from 1 to 1000 starts
    "#]],
    );
    refuses_for_arm(
        &with_limits(&["--write", "arm.toml"]),
        expect![[r#"
        error: the output `arm.toml` would overwrite the input `arm.toml`
        help: give another file
    "#]],
    );
}

/// Goal: models whose coordinates do not move freely, and domains without room, are refused. Method: one of each kind.
#[test]
fn models_without_a_free_motion_are_refused() {
    let folder = folder();
    let text = std::fs::read_to_string(folder.path().join("arm.toml")).unwrap();
    std::fs::write(folder.path().join("high.toml"), format!("{text}[domain]\nhigh = \"q1 > 2\"\n")).unwrap();
    refuses(
        folder.path(),
        &["high.toml", "--limit", "q1=1", "--limit", "q2=1"],
        expect![[r#"
        error: the limits of `q1` exclude one another: at least 2 by the condition `high`, at most 1 by the limit of `q1`
        help: change one of the two limits
    "#]],
    );
    let library = |model: &str| root().join("models").join(model).to_str().unwrap().to_owned();
    refuses(
        folder.path(),
        &[&library("four_bar")],
        expect![[r#"
        error: the model has loops, which relate its coordinates
        help: design the motion of a model without the closing joints, or give `tripos fit` measured motions
    "#]],
    );
    refuses(
        folder.path(),
        &[&library("disk")],
        expect![[r#"
        error: the speed `u1` is no rate of a coordinate
        help: define each speed as the rate of a coordinate, such as u1 = "q1'"
    "#]],
    );
    refuses(
        folder.path(),
        &[&library("driven_pendulum")],
        expect![[r#"
        error: the model depends on the time `t`, and a designed motion is periodic
        help: replace the prescribed motion by a coordinate
    "#]],
    );
}

/// Goal: a robot from a description has the limits of its joints. Method: a SCARA robot, of which the last joint has no
/// limits in the file.
#[test]
fn a_robot_from_a_description_is_excited() {
    let folder = tempfile::tempdir().unwrap();
    let description = root().join("tests/data/robots/scara.urdf");
    let (status, _, err) = tripos_in(folder.path(), &["new", "scara", "--from", description.to_str().unwrap()]);
    assert_eq!(status, 0, "{err}");
    let (status, out, err) =
        tripos_in(folder.path(), &["excite", "scara", "--starts", "1", "--limit", "q_j4=3", "--json"]);
    let found: Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{out}{err}"));
    assert!(status <= 1 && found["motion"].as_array().unwrap().len() == 4, "{found:#}");
    for quantity in found["limits"].as_array().unwrap().iter().step_by(3) {
        let of = |key: &str| quantity[key].as_f64().unwrap();
        assert!(of("low") <= of("least") && of("largest") <= of("high"), "{quantity}");
    }
}
