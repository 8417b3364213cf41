//! Parameters from measurements: `tripos fit`.
//!
//! Truth: SciPy, from formulas that are written by hand in tests/data/fit/reference.py.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::support::{root, tripos_in};
use expect_test::{Expect, expect};
use serde_json::Value;

/// Result of a fit as JSON, and its status. The arguments follow `fit`, in the folder of the data.
fn fit(arguments: &[&str]) -> (i32, Value) {
    let (status, out, err) = tripos_in(&root().join("tests/data/fit"), &[&["fit"], arguments, &["--json"]].concat());
    (status, serde_json::from_str(&out).unwrap_or_else(|_| panic!("{out}{err}")))
}

/// Checks estimates and standard errors against those of SciPy.
fn check_reference(found: &Value, name: &str, accuracy: f64) {
    let text = std::fs::read_to_string(root().join("tests/data/fit/reference.json")).unwrap();
    let reference: Value = serde_json::from_str(&text).unwrap();
    let of = |list: &Value, at: usize| list[at].as_f64().unwrap();
    let estimates = found["estimates"].as_array().unwrap();
    let names = reference[name]["names"].as_array().unwrap();
    assert_eq!(estimates.len(), names.len(), "{found:#}");
    for (at, (estimate, known)) in estimates.iter().zip(names).enumerate() {
        assert_eq!(&estimate["name"], known);
        let (value, error) = (of(&reference[name]["values"], at), of(&reference[name]["errors"], at));
        let (own, own_error) = (estimate["value"].as_f64().unwrap(), estimate["error"].as_f64().unwrap());
        assert!((own - value).abs() <= accuracy * error, "{known}: {own}, not {value}");
        assert!((own_error / error - 1.0).abs() <= accuracy, "{known}: ± {own_error}, not {error}");
    }
}

/// Goal: estimates and standard errors of runs are those of nonlinear least squares. Method: a pendulum with drag, of
/// which length, drag and first angle follow from noisy angles.
#[test]
fn runs_are_fitted_as_scipy_fits_them() {
    let (status, found) = fit(&[
        "swing_scene.toml",
        "--data",
        "swing.csv",
        "--for",
        "l",
        "--for",
        "c",
        "--for",
        "theta",
        "--rtol",
        "1e-10",
    ]);
    assert_eq!(status, 0);
    check_reference(&found, "swing", 2e-4);
}

/// Goal: base parameters and standard errors are those of weighted linear least squares. Method: two links in a plane,
/// with other noise at each joint.
#[test]
fn forces_are_fitted_as_scipy_fits_them() {
    let (status, found) = fit(&["arm.toml", "--data", "arm.csv"]);
    assert_eq!(status, 0);
    check_reference(&found, "arm", 1e-6);
}

/// Goal: text and residuals say what a reader needs. Method: the words for a scene with an unknown that the data do not
/// tell, and the head of the table of residuals.
#[test]
fn words_name_what_the_data_do_not_tell() {
    let folder = tempfile::tempdir().unwrap();
    let residuals = folder.path().join("residuals.csv");
    let (status, out, err) = tripos_in(
        &root().join("tests/data/fit"),
        &[
            "fit",
            "swing_scene.toml",
            "--data",
            "swing.csv",
            "--for",
            "l=0.1:2",
            "--for",
            "c",
            "--for",
            "m",
            "--for",
            "theta",
            "--prior",
            "l=0.75:0.01",
            "--residuals",
            residuals.to_str().unwrap(),
        ],
    );
    assert_eq!(status, 1);
    expect![[r#"
        l = 0.7499 ± 8.4e-4 m  (scene: 1)
        c = 0.123193 kg/s, not told by the data  (scene: 0.1)
        m = 0.41807 kg, not told by the data  (scene: 1)
        theta = 1.197 ± 0.00617  (scene: 1)

        theta: 120 values, residuals 0.0219053 (root mean square)
        not told by the data: no measured value changes if c changes by 0.294669 and m changes by 1
    "#]]
    .assert_eq(&format!("{out}{err}"));
    let table = std::fs::read_to_string(residuals).unwrap();
    assert_eq!(table.lines().next().unwrap(), "data,quantity,t,residual,in_deviations");
    assert_eq!(table.lines().count(), 121);
}

/// Folder with the models and the data, in which a table `data.csv` can be replaced.
struct DataFolder(tempfile::TempDir);

impl DataFolder {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        for file in ["swing.toml", "swing_scene.toml", "arm.toml", "arm.csv"] {
            std::fs::copy(root().join("tests/data/fit").join(file), folder.path().join(file)).unwrap();
        }
        Self(folder)
    }

    /// Checks the error of a fit whose table has this text. The arguments follow `fit`.
    #[expect(clippy::needless_pass_by_value, reason = "expect! makes values")]
    fn refuses(&self, table: &str, arguments: &[&str], expected: Expect) {
        std::fs::write(self.0.path().join("data.csv"), table).unwrap();
        let (status, out, err) = tripos_in(self.0.path(), &[&["fit"], arguments].concat());
        assert_eq!(status, 2, "{out}{err}");
        expected.assert_eq(&err);
    }
}

/// Goal: wrong tables get an error with its place, its reason and a hint. Method: one of each kind.
#[test]
fn wrong_tables_are_refused() {
    let folder = DataFolder::new();
    let scene = ["swing_scene.toml", "--data", "data.csv", "--for", "l"];
    folder.refuses(
        "t,theta\n0,1\n1,nan\n",
        &scene,
        expect![[r#"
        error: the column `theta` has no number here: `nan`
         --> data.csv:3:1
          |
        3 | 1,nan
          | ^^^^^
          |
          = help: give a finite number, or leave the row out
    "#]],
    );
    folder.refuses(
        "t,theta\n0,1\n1,0.5\n0.5,0.2\n",
        &scene,
        expect![[r#"
        error: the time goes from 1 s to 0.5 s
         --> data.csv:4:1
          |
        4 | 0.5,0.2
          | ^^^^^^^
          |
          = help: put the rows in the order of time, each instant once
    "#]],
    );
    folder.refuses(
        "t,theta\n0,1\n1\n",
        &scene,
        expect![[r#"
        error: a row has one cell, but the head has 2
         --> data.csv:3:1
          |
        3 | 1
          | ^
          |
          = help: give a head with names, and rows of as many numbers
    "#]],
    );
    folder.refuses(
        "t,angle\n0,1\n1,0.5\n",
        &scene,
        expect![[r#"
            error: the column `angle` is no quantity of the scene: unknown name `angle`
             --> data.csv:1:1
              |
            1 | t,angle
              | ^^^^^^^
              |
              = help: known here: `g`, `m`, `l`, `c`, `theta`, `theta'`, `omega`, `bob_force_r2`, `omega'`, `kinetic_energy`, `potential_energy`, `total_energy`
        "#]],
    );
    folder.refuses(
        "theta\n1\n0.5\n",
        &scene,
        expect![[r#"
            error: the table has no column `t`
             --> data.csv:1:1
              |
            1 | theta
              | ^^^^^
              |
              = help: known here: `theta`
        "#]],
    );
    folder.refuses(
        "t,theta\n",
        &scene,
        expect![[r#"
        error: the table has no rows
         --> data.csv:1:1
          |
        1 | t,theta
          | ^
          |
          = help: give a row for each instant
    "#]],
    );
    folder.refuses(
        "t,theta\n-1,1\n1,0.5\n",
        &scene,
        expect![[r#"
        error: `data.csv` begins at -1 s, before the scene begins at 0 s
        help: let `span` of the scene begin with the first measured instant
    "#]],
    );
}

/// Goal: wrong options get an error with its reason and a hint. Method: one of each kind.
#[test]
fn wrong_options_are_refused() {
    let folder = DataFolder::new();
    let good = "t,theta\n0,1\n1,0.5\n";
    folder.refuses(
        good,
        &["swing_scene.toml", "--data", "data.csv", "--for", "len"],
        expect![[r#"
            error: the scene has no parameter or start value `len`
            help: known here: `g`, `m`, `l`, `c`, `theta`, `omega`
        "#]],
    );
    folder.refuses(
        good,
        &["swing_scene.toml", "--data", "data.csv"],
        expect![[r#"
        error: nothing is to be fitted
        help: name parameters or numbers of the start, as in `--for m --for theta`
    "#]],
    );
    folder.refuses(
        good,
        &["swing_scene.toml", "--data", "data.csv", "--for", "l=2:1"],
        expect![[r#"
        error: the bounds of `--for l=2:1` leave no room
        help: give the lower bound first
    "#]],
    );
    folder.refuses(
        good,
        &["swing_scene.toml", "--data", "data.csv", "--for", "l", "--prior", "c=1:1"],
        expect![[r#"
        error: `c` has a prior and is not fitted
        help: add `--for c`, or leave the prior out
    "#]],
    );
    folder.refuses(
        good,
        &["swing_scene.toml", "--data", "data.csv", "--for", "l", "--possible"],
        expect![[r#"
        error: `--possible` belongs to the fit of a model, and `swing_scene.toml` is a scene
        help: leave `--possible` out, or give a model
    "#]],
    );
    folder.refuses(
        good,
        &["swing_scene.toml", "--data", "none.csv", "--for", "l"],
        expect![[r#"
        error: cannot read the file: No such file or directory (os error 2)
        --> none.csv
         = help: check the path
    "#]],
    );
    folder.refuses(
        good,
        &["swing_scene.toml", "--data", "data.csv", "--for", "l", "--noise", "phi=1"],
        expect![[r#"
        error: there is no measured quantity `phi`
        help: known here: `theta`
    "#]],
    );
    folder.refuses(
        good,
        &["arm.toml", "--data", "arm.csv", "--for", "m1"],
        expect![[r#"
        error: `--for` belongs to the fit of a scene, and `arm.toml` is a model
        help: leave `--for` out, or give a scene
    "#]],
    );
    folder.refuses(
        good,
        &["arm.toml", "--data", "data.csv"],
        expect![[r#"
            error: the table has no column `q1`
             --> data.csv:1:1
              |
            1 | t,theta
              | ^^^^^^^
              |
              = help: known here: `t`, `theta`
        "#]],
    );
}

/// Goal: data that tell nothing, and files that would be lost, are refused. Method: one of each kind.
#[test]
fn data_that_tell_nothing_are_refused() {
    let folder = DataFolder::new();
    let good = "t,theta\n0,1\n1,0.5\n";
    let scene = ["swing_scene.toml", "--data", "data.csv", "--for", "l"];
    folder.refuses(
        good,
        &[&scene[..], &["--residuals", "data.csv"]].concat(),
        expect![[r#"
        error: the output `data.csv` would overwrite the input `data.csv`
        help: give another file
    "#]],
    );
    folder.refuses(
        good,
        &[&scene[..], &["--until", "3"]].concat(),
        expect![[r#"
        error: `--until` means nothing for a fit
        help: leave `--until` out: the table states the instants
    "#]],
    );
    folder.refuses(
        good,
        &[&scene[..], &["--for", "theta"]].concat(),
        expect![[r#"
        error: there are 2 measured values for 2 unknowns
        help: give more rows than unknowns, or find fewer unknowns
    "#]],
    );
    folder.refuses(
        good,
        &[&scene[..], &["--data", "data.csv"]].concat(),
        expect![[r#"
        error: `data.csv` is given twice
        help: give each table once
    "#]],
    );
    folder.refuses(
        "t;theta\n0;1\n",
        &scene,
        expect![[r#"
        error: the columns are not separated by commas
         --> data.csv:1:1
          |
        1 | t;theta
          | ^^^^^^^
          |
          = help: separate the names and the numbers by commas
    "#]],
    );
    let still: String = (0..12).map(|k| format!("{k},{},{}\n", k % 3, k % 2)).collect::<Vec<_>>().concat();
    folder.refuses(
        &format!("t,q1,q2\n{still}"),
        &["arm.toml", "--data", "data.csv"],
        expect![[r#"
        error: all measured forces are 0, which tells no parameter
        help: give columns for inputs, or for forces such as `force(u1)`
    "#]],
    );
    folder.refuses(
        good,
        &["arm.toml", "--data", "arm.csv", "--filter", "-3"],
        expect![[r#"
        error: a filter at -3 Hz does not fit instants every 0.0200501 s
        help: give a frequency above 0 and below 24.9375 Hz
    "#]],
    );
    folder.refuses(
        good,
        &["arm.toml", "--data", "arm.csv", "--filter", "100"],
        expect![[r#"
            error: a filter at 100 Hz does not fit instants every 0.0200501 s
            help: give a frequency above 0 and below 24.9375 Hz
        "#]],
    );
}
