//! Messages for wrong models, word for word: names and form.
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

#[test]
fn a_misspelt_section_is_not_ignored() {
    check(
        &edited(&[("[gravity]", "[gravtiy]")], ""),
        &expect![[r"
        error: unknown key `gravtiy` in a model file
          --> model.toml:37:2
           |
        37 | [gravtiy]
           |  ^^^^^^^
           |
           = help: did you mean `gravity`?"]],
    );
}

#[test]
fn misspelt_keys_are_all_reported() {
    check(
        &edited(&[("axis", "axs"), ("centre", "center")], ""),
        &expect![[r#"
        error: frame `A` has no `axis`
          --> model.toml:22:1
           |
        22 | A = { from = "N", axs = 3, angle = "q" }
           | ^
           |
           = help: add `axis = …`

        error: unknown key `axs` in a frame
          --> model.toml:22:19
           |
        22 | A = { from = "N", axs = 3, angle = "q" }
           |                   ^^^
           |
           = help: did you mean `axis`?

        error: body `rod` has no `centre`
          --> model.toml:31:9
           |
        31 | [bodies.rod]
           |         ^^^
           |
           = help: add `centre = …`

        error: unknown key `center` in a body
          --> model.toml:33:1
           |
        33 | center = "C"
           | ^^^^^^
           |
           = help: did you mean `centre`?"#]],
    );
}

#[test]
fn a_misspelt_parameter_gets_the_nearest_name() {
    check(
        &edited(&[("-length", "-legnth")], ""),
        &expect![[r#"
        error: unknown name `legnth`
          --> model.toml:26:49
           |
        26 | C = { from = "P", frame = "A", position = [0, "-legnth", 0] }
           |                                                 ^^^^^^
           |
           = help: did you mean `length`?"#]],
    );
}

#[test]
fn an_undefined_frame_is_one_error_however_often_it_is_used() {
    check(
        &edited(
            &[("frame = \"A\", position", "frame = \"X\", position"), ("frame = \"A\"\n", "frame = \"X\"\n")],
            "[forces.push]\non = \"rod\"\nframe = \"X\"\nvector = [0, 0, 0]\n",
        ),
        &expect![[r#"
            error: there is no frame `X`
              --> model.toml:26:28
               |
            26 | C = { from = "P", frame = "X", position = [0, "-length", 0] }
               |                            ^
               |
              ::: model.toml:32:10
               |
            32 | frame = "X"
               |          - also here, and 1 times more
               |
               = help: known here: `N`, `A`"#]],
    );
}

#[test]
fn a_frame_cycle_is_shown_whole() {
    check(
        &edited(
            &[(
                "from = \"N\", axis = 3, angle = \"q\" }",
                "from = \"B\", axis = 3, angle = \"q\" }\nB = { from = \"A\", axis = 1, angle = 0 }",
            )],
            "",
        ),
        &expect![[r#"
            error: `A` is placed from itself: A -> B -> A
              --> model.toml:22:15
               |
            22 | A = { from = "B", axis = 3, angle = "q" }
               |               ^
               |
               = help: every frame and point must lead back to the inertial frame and the origin"#]],
    );
}

#[test]
fn a_name_for_two_things_shows_both_places() {
    check(
        &edited(&[("A = {", "m = {"), ("frame = \"A\"", "frame = \"m\""), ("frame = \"A\"\n", "frame = \"m\"\n")], ""),
        &expect![[r#"
            error: `m` is declared twice: as a parameter and as a frame
              --> model.toml:22:1
               |
            22 | m = { from = "N", axis = 3, angle = "q" }
               | ^
               |
              ::: model.toml:4:1
               |
             4 | m = { unit = "kg", value = 2, positive = true }
               | - first declared here
               |
               = help: rename one of the two"#]],
    );
}

#[test]
fn a_key_stated_twice_shows_both_places() {
    check(
        &edited(&[("x = { unit = \"m\" }", "x = { unit = \"m\" }\nx = { unit = \"m\" }")], ""),
        &expect![[r#"
        error: `x` is stated twice
          --> model.toml:11:1
           |
        11 | x = { unit = "m" }
           | ^
           |
          ::: model.toml:10:1
           |
        10 | x = { unit = "m" }
           | - first stated here
           |
           = help: remove or rename one of the two"#]],
    );
}

#[test]
fn a_section_stated_twice_is_one_error() {
    check(
        &edited(&[], "[gravity]\nframe = \"N\"\n"),
        &expect![[r"
        error: `gravity` is stated twice
          --> model.toml:40:2
           |
        40 | [gravity]
           |  ^^^^^^^
           |
          ::: model.toml:37:2
           |
        37 | [gravity]
           |  ------- first stated here
           |
           = help: remove or rename one of the two"]],
    );
}

#[test]
fn a_reserved_name_is_refused() {
    check(
        &edited(&[("q = {", "t = {"), ("\"q'\"", "\"t'\""), ("\"q\"", "\"t\"")], ""),
        &expect![[r#"
        error: `t` is reserved
          --> model.toml:11:1
           |
        11 | t = { unit = "rad" }
           | ^
           |
           = help: choose another name: this one belongs to the expression language"#]],
    );
}

#[test]
fn an_empty_file_says_so() {
    check(
        "",
        &expect![[r"
        error: the model file is empty
        --> model.toml
         = help: docs/model.md describes the format"]],
    );
}

#[test]
fn a_file_of_comments_says_so() {
    check(
        "# nothing yet\n",
        &expect![[r"
        error: the model file holds nothing but comments
        --> model.toml
         = help: docs/model.md describes the format"]],
    );
}

#[test]
fn a_file_without_sections_lists_what_is_missing() {
    check(
        "name = \"Nothing\"\n",
        &expect![[r#"
        error: the model has no bodies
        --> model.toml
         = help: add [bodies.NAME] or [particles.NAME]

        error: the model has no coordinates
        --> model.toml
         = help: add [coordinates]; a problem without them is statics, which is not derived here

        error: the model has no inertial frame
        --> model.toml
         = help: add [inertial] with frame = "N" and origin = "O""#]],
    );
}

#[test]
fn a_missing_quote_is_an_error_of_toml() {
    check(
        &edited(&[("\"q'\"", "q'")], ""),
        &expect![[r"
        error: missing opening quote, expected `'`
          --> model.toml:15:6
           |
        15 | u2 = q'
           |      ^
           |
           = help: the file must be valid TOML: `key = value`, with text and formulas in quotes"]],
    );
}

#[test]
fn a_very_long_line_is_not_printed() {
    check(
        &edited(&[("-length", &format!("{}k", "length+".repeat(100_000)))], ""),
        &expect![[r#"
        error: unknown name `k`
        --> model.toml:26:700048
         = note: in a very long line, at `k", 0] }`
         = help: known here: `m`, `length`, `I`, `g`, `x`, `q`"#]],
    );
}

#[test]
fn a_divisor_that_is_zero_by_meaning_is_found() {
    check(
        &edited(&[("-length", "length/(cos(q)^2 + sin(q)^2 - 1)")], ""),
        &expect![[r#"
        error: division by zero: sin(q)^2 - 1 + cos(q)^2 is zero
          --> model.toml:26:48
           |
        26 | C = { from = "P", frame = "A", position = [0, "length/(cos(q)^2 + sin(q)^2 - 1)", 0] }
           |                                                ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
           |
           = help: this divisor vanishes identically"#]],
    );
}
