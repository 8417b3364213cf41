//! Messages for impossible constraints: too many speeds, equations that repeat or contradict others.
//!
//! `UPDATE_EXPECT=1 cargo test` accepts new words; read them before you commit them.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::common;

use common::{edited, errors};
use expect_test::{Expect, expect};

fn check(text: &str, expected: &Expect) {
    let lines: Vec<String> = errors(text).to_string().lines().map(|l| l.trim_end().to_owned()).collect();
    expected.assert_eq(&lines.join("\n"));
}

/// The pendulum on a cart with these constraints.
fn held(constraints: &str) -> String {
    edited(&[], &format!("[constraints]\n{constraints}"))
}

#[test]
fn a_constraint_takes_a_speed_away() {
    check(
        &held("still = { equation = \"x' = 0\" }\n"),
        &expect![[r#"
        error: 2 speeds for 2 generalized coordinates and 1 motion constraint: 1 is left
          --> model.toml:15:1
           |
        15 | u2 = "q'"
           | ^^
           |
           = help: define 1 speed that the constraints (`still`) leave independent; the other rates of x, q follow"#]],
    );
}

#[test]
fn what_cannot_move_is_refused() {
    let text = "still = { equation = \"x' = 0\" }\nhanging = { equation = \"omega(rod) @ N [3] = 0\" }\n";
    check(
        &held(text),
        &expect![[r#"
        error: 2 motion constraints on 2 coordinates: nothing can move
          --> model.toml:14:1
           |
        14 | u1 = "x'"
           | ^^
           |
           = help: define no speed, since all rates follow, or leave one of `still`, `hanging` out"#]],
    );
}

#[test]
fn a_constraint_that_repeats_another_is_named() {
    let text = "still = { equation = \"x' = 0\" }\nagain = { equation = \"v(P) @ N [1] = 0\" }\n";
    check(
        &held(text),
        &expect![[r#"
        error: the constraint `again` follows from those before it
          --> model.toml:42:23
           |
        42 | again = { equation = "v(P) @ N [1] = 0" }
           |                       ^^^^^^^^^^^^^^^^
           |
           = help: remove it, or correct one of the others"#]],
    );
}

#[test]
fn a_constraint_that_contradicts_another_is_named() {
    let text = "turning = { equation = \"q' = 0\" }\nfaster = { equation = \"length*q' = length*sqrt(g/length)\" }\n";
    check(
        &held(text),
        &expect![[r#"
        error: the constraint `faster` contradicts those before it
          --> model.toml:42:24
           |
        42 | faster = { equation = "length*q' = length*sqrt(g/length)" }
           |                        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
           |
           = help: remove it, or correct one of the others"#]],
    );
}

#[test]
fn a_speed_that_the_constraints_hold_is_not_independent() {
    check(
        &edited(&[("u2 = \"q'\"\n", "")], "[constraints]\nstill = { equation = \"x' = 0\" }\n"),
        &expect![[r#"
        error: the speeds are not independent: `u1` follows from the others and the constraints
          --> model.toml:14:7
           |
        14 | u1 = "x'"
           |       ^^
           |
           = help: the speeds must determine every q' uniquely"#]],
    );
}

#[test]
fn a_multiplier_has_a_name_of_its_own() {
    let text = "[constraints]\nstill = { equation = \"x' = 0\" }\n";
    check(
        &edited(&[("u2 = \"q'\"\n", ""), ("u1 = \"x'\"", "lambda_still = \"q'\"")], text),
        &expect![[r#"
        error: `lambda_still` is declared twice: as a speed and as a multiplier
          --> model.toml:40:23
           |
        40 | still = { equation = "x' = 0" }
           |                       ^^^^^^
           |
          ::: model.toml:14:1
           |
        14 | lambda_still = "q'"
           | ------------ first declared here
           |
           = help: rename one of the two"#]],
    );
}

#[test]
fn rolling_is_told_from_what_cannot_slip() {
    // The hinge is a point of the rod: nothing slips on the ground but with the cart.
    check(
        &edited(&[], "[rolling.hinge]\nbody = \"rod\"\nat = \"P\"\n"),
        &expect![[r#"
        error: 2 speeds for 2 generalized coordinates and 1 motion constraint: 1 is left
          --> model.toml:15:1
           |
        15 | u2 = "q'"
           | ^^
           |
           = help: define 1 speed that the constraints (`hinge_1`) leave independent; the other rates of x, q follow"#]],
    );
}
