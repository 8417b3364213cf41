//! Equations in base parameters: `tripos emit --base`.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::support::{root, tripos_in};
use expect_test::{Expect, expect};

/// Goal: what cannot be written in base parameters is refused, and what becomes longer is told. Method: the words, and
/// the folder, which is not created by a refusal.
#[test]
fn refusals_and_warnings_of_base_parameters() {
    let models = root().join("models");
    let is = |model: &str, arguments: &[&str], status: i32, expected: Expect| {
        let folder = tempfile::tempdir().unwrap();
        let path = models.join(model);
        let all = [&["emit", path.to_str().unwrap(), "--base", "--out", "out"], arguments].concat();
        let (found, _, err) = tripos_in(folder.path(), &all);
        assert_eq!(found, status, "{err}");
        assert_eq!(folder.path().join("out").exists(), status == 0, "{model}");
        expected.assert_eq(&err.replace(root().to_str().unwrap(), "ROOT"));
    };
    is(
        "puma560",
        &["--language", "js"],
        2,
        expect![[r#"
        error: equations in base parameters are written in C, Python, MATLAB and for CasADi
        help: leave `--base` out, or give one of these languages
    "#]],
    );
    is(
        "puma560",
        &["--language", "c", "--formulation", "lagrange"],
        2,
        expect![[r#"
        error: equations in base parameters are those of Kane's method, not of `lagrange`
        help: leave `--formulation` out, or give --formulation kane
    "#]],
    );
    is(
        "puma560",
        &["--language", "c", "--functions", "regressor"],
        2,
        expect![[r#"
        error: the function `regressor` belongs to the equations in the parameters of the model
        help: leave `--base` out
    "#]],
    );
    is(
        "euler_top",
        &["--language", "c"],
        0,
        expect![[r#"
        warning: the mass matrix and the forcing take 93 operations in base parameters, and 11 in the parameters of the model
        #include "euler_top_base_kane.h", and compile euler_top_base_kane.c with your program; it needs the mathematical library, -lm
    "#]],
    );
    is(
        "puma560",
        &["--language", "c"],
        0,
        expect![[r##"
        #include "puma560_base_kane.h", and compile puma560_base_kane.c with your program; it needs the mathematical library, -lm
    "##]],
    );
}
