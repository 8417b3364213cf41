//! Messages for wrong publication files, word for word: keys, ids, systems and listings.
//!
//! `UPDATE_EXPECT=1 cargo test` accepts new words; read them before you commit them.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::publications;

use expect_test::expect;
use publications::{check, check_edit, edited};

#[test]
fn an_empty_file_says_so() {
    check(
        "",
        &expect![[r"
        error: the publication file is empty
        --> publication.toml
         = help: docs/publication.md describes the format"]],
    );
}

#[test]
fn a_file_without_entries_says_so() {
    check(
        "title = \"nothing\"\nequation = []\n",
        &expect![[r"
        error: the publication has no entries
        --> publication.toml
         = help: add [[equation]] entries; docs/publication.md describes the format"]],
    );
}

#[test]
fn a_misspelt_kind_of_entry_is_one_error() {
    check(
        "[[equations]]\nid = \"1\"\n",
        &expect![[r"
        error: unknown key `equations` in a publication file
         --> publication.toml:1:3
          |
        1 | [[equations]]
          |   ^^^^^^^^^
          |
          = help: did you mean `equation`?"]],
    );
}

#[test]
fn unknown_and_missing_keys_are_all_reported() {
    let edits = [("quantity = \"T\"", "quantty = \"T\""), ("section = \"A\"\n", ""), ("set = \"text\"\n", "")];
    check(
        &edited(&edits),
        &expect![[r#"
        error: an equation has no `quantity`
          --> publication.toml:24:1
           |
        24 | [[equation]]
           | ^^^^^^^^^^^^
           |
           = help: add `quantity = …`

        error: unknown key `quantty` in an equation
          --> publication.toml:27:1
           |
        27 | quantty = "T"
           | ^^^^^^^
           |
           = help: did you mean `quantity`?

        error: a listing has no `section`
          --> publication.toml:41:1
           |
        41 | [[listing]]
           | ^^^^^^^^^^^
           |
           = help: add `section = …`

        error: an initial value has no `set`
          --> publication.toml:48:1
           |
        48 | [[initial]]
           | ^^^^^^^^^^^
           |
           = help: add `set = …`"#]],
    );
}

#[test]
fn an_id_for_two_entries_shows_both_places() {
    check_edit(
        "id = \"2-T\"",
        "id = \"1-vx\"",
        &expect![[r#"
        error: the id `1-vx` is used twice
          --> publication.toml:25:7
           |
        25 | id = "1-vx"
           |       ^^^^
           |
          ::: publication.toml:13:7
           |
        13 | id = "1-vx"
           |       ---- first used here
           |
           = help: ids are unique in a file: add a suffix such as -line2"#]],
    );
}

#[test]
fn an_id_that_a_system_gives_to_a_row_is_taken() {
    let edits = [("id = \"2-T\"", "id = \"3-row2\""), ("3-A{i}", "3-A"), ("3-E{i}{j}", "3-E{i}")];
    check(
        &edited(&edits),
        &expect![[r#"
        error: `matrix_ids` has no {j}: its ids would be the same
          --> publication.toml:38:15
           |
        38 | matrix_ids = "3-E{i}"
           |               ^^^^^^
           |
           = help: write the row as {i} and the column as {j}

        error: `right_ids` has no {i}: its ids would be the same
          --> publication.toml:39:14
           |
        39 | right_ids = "3-A"
           |              ^^^
           |
           = help: write the row as {i}"#]],
    );
    check_edit(
        "id = \"2-T\"",
        "id = \"3-row2\"",
        &expect![[r#"
        error: the id `3-row2`, of a part of this entry, is used twice
          --> publication.toml:32:7
           |
        32 | id = "3"
           |       ^
           |
          ::: publication.toml:25:7
           |
        25 | id = "3-row2"
           |       ------ first used here
           |
           = help: ids are unique in a file: add a suffix such as -line2"#]],
    );
}

#[test]
fn an_unknown_formulation_gets_the_nearest_name() {
    check_edit(
        "formulation = \"kane\"",
        "formulation = \"Kanes\"",
        &expect![[r#"
        error: there is no formulation `Kanes`
          --> publication.toml:44:16
           |
        44 | formulation = "Kanes"
           |                ^^^^^
           |
           = help: did you mean `kane`?"#]],
    );
}

#[test]
fn wrong_unknowns_are_named() {
    check_edit(
        "[\"x''\", \"q''\"]",
        "[\"u1'\", \"q''\"]",
        &expect![[r#"
        error: `u1'` is not an unknown of lagrange
          --> publication.toml:35:14
           |
        35 | unknowns = ["u1'", "q''"]
           |              ^^^
           |
           = help: known here: `x''`, `q''`"#]],
    );
    check_edit(
        "[\"x''\", \"q''\"]",
        "[\"q''\", \"q''\"]",
        &expect![[r#"
            error: `q''` is named twice
              --> publication.toml:35:21
               |
            35 | unknowns = ["q''", "q''"]
               |              ---    ^^^
               |              |
               |              first named here
               |
               = help: name each once"#]],
    );
}

#[test]
fn an_entry_of_the_matrix_that_contains_an_unknown_is_refused() {
    let edits = [
        ("[\"2*m\", \"m*length*cos(q)\"]", "[\"2*m\", \"m*length*cos(q)*x''\"]"),
        ("right = [\"bob*q'^2\", \"-g*bob\"]", "right = [\"bob*q'^2 - m*q''\", \"-q''*bob\"]"),
    ];
    check(
        &edited(&edits),
        &expect![[r#"
        error: an entry of the matrix contains the unknown `x''`
          --> publication.toml:36:20
           |
        36 | matrix = [["2*m", "m*length*cos(q)*x''"], ["m*length*cos(q)", "I + m*length^2"]]
           |                    ^^^^^^^^^^^^^^^^^^^
           |
           = help: a row reads Σ entry·unknown = right: put the factor of `x''` into its column of the matrix"#]],
    );
    check_edit(
        "unknowns = [",
        "equations = [\"x'' = 0\"]\nunknowns = [",
        &expect![[r#"
        error: `matrix` beside `equations`
          --> publication.toml:37:10
           |
        37 | matrix = [["2*m", "m*length*cos(q)"], ["m*length*cos(q)", "I + m*length^2"]]
           |          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
           |
           = help: a system is either `equations`, or `unknowns`, `matrix` and `right`

        error: `right` beside `equations`
          --> publication.toml:38:9
           |
        38 | right = ["bob*q'^2", "-g*bob"]
           |         ^^^^^^^^^^^^^^^^^^^^^^
           |
           = help: a system is either `equations`, or `unknowns`, `matrix` and `right`

        error: `matrix_ids` beside `equations`
          --> publication.toml:39:14
           |
        39 | matrix_ids = "3-E{i}{j}"
           |              ^^^^^^^^^^^
           |
           = help: a system is either `equations`, or `unknowns`, `matrix` and `right`

        error: `right_ids` beside `equations`
          --> publication.toml:40:13
           |
        40 | right_ids = "3-A{i}"
           |             ^^^^^^^^
           |
           = help: a system is either `equations`, or `unknowns`, `matrix` and `right`"#]],
    );
}

/// A program may use what it has computed before; only a linear system has its unknowns apart.
#[test]
fn a_listing_may_contain_any_symbol() {
    let text = edited(&[("\"-g*bob\", 0]", "\"-g*bob\", \"u2'\"]")]);
    publications::load_text(&text, &mut publications::base()).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn a_matrix_that_does_not_fit_is_refused() {
    let edits = [("[\"2*m\", \"m*length*cos(q)\"]", "[\"2*m\"]"), ("[[1, 0], [0, \"m\"]]", "[[1, 0]]")];
    check(
        &edited(&edits),
        &expect![[r#"
        error: row 1 of the matrix has 1 entry, not 2
          --> publication.toml:36:11
           |
        36 | matrix = [["2*m"], ["m*length*cos(q)", "I + m*length^2"]]
           |           ^^^^^^^
           |
           = help: one entry for each unknown

        error: the matrix has 1 row, not 2
          --> publication.toml:47:10
           |
        47 | matrix = [[1, 0]]
           |          ^^^^^^^^
           |
           = help: one row and one column for each speed of the state"#]],
    );
    check_edit(
        "right = [\"bob*q'^2\", \"-g*bob\"]",
        "right = [0]",
        &expect![[r"
        error: `right` has 1 entry for 2 rows
          --> publication.toml:37:9
           |
        37 | right = [0]
           |         ^^^
           |
           = help: one right-hand side for each row of the matrix"]],
    );
}

#[test]
fn a_state_is_of_coordinates_and_speeds() {
    check_edit(
        "state = [\"q\", \"x\", \"u2\", \"u1\"]",
        "state = [\"q\", \"x\", \"u2\"]",
        &expect![[r#"
        error: `derivative` has 4 entries for a state of 3
          --> publication.toml:46:14
           |
        46 | derivative = ["u2", "u1", "-g*bob", 0]
           |              ^^^^^^^^^^^^^^^^^^^^^^^^^
           |
           = help: one derivative for each entry of the state, 0 where it is left zero

        error: the matrix has 2 rows, not 1
          --> publication.toml:47:10
           |
        47 | matrix = [[1, 0], [0, "m"]]
           |          ^^^^^^^^^^^^^^^^^^
           |
           = help: one row and one column for each speed of the state"#]],
    );
    check_edit(
        "state = [\"q\", \"x\", \"u2\", \"u1\"]",
        "state = [\"q\", \"u1\", \"x'\", \"u1\"]",
        &expect![[r#"
        error: `x'` is not a coordinate or a speed
          --> publication.toml:45:22
           |
        45 | state = ["q", "u1", "x'", "u1"]
           |                      ^^
           |
           = help: did you mean `x`?

        error: `u1` is named twice
          --> publication.toml:45:28
           |
        45 | state = ["q", "u1", "x'", "u1"]
           |                --          ^^
           |                |
           |                first named here
           |
           = help: name each once"#]],
    );
}

#[test]
fn newton_euler_systems_have_a_frame_and_others_have_none() {
    check_edit(
        "formulation = \"lagrange\"\n",
        "formulation = \"lagrange\"\nframe = \"N\"\n",
        &expect![[r#"
        error: only a newton-euler system has a `frame`
          --> publication.toml:35:9
           |
        35 | frame = "N"
           |         ^^^
           |
           = help: remove it: generalized forces have no components"#]],
    );
    let newton_euler = (
        "formulation = \"lagrange\"\nunknowns = [\"x''\", \"q''\"]",
        "formulation = \"newton-euler\"\nunknowns = [\"u1'\", \"u2'\"]",
    );
    check(
        &edited(&[newton_euler]),
        &expect![[r"
        error: a system has no `frame`
          --> publication.toml:31:1
           |
        31 | [[system]]
           | ^^^^^^^^^^
           |
           = help: add `frame = …`"]],
    );
}
