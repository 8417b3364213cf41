//! Messages for wrong publication files, word for word: names, formulas and numbers.
//!
//! `UPDATE_EXPECT=1 cargo test` accepts new words; read them before you commit them.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::publications;

use expect_test::expect;
use publications::{check, check_edit, edited};

#[test]
fn an_unknown_quantity_is_marked_within_its_name() {
    let edits = [
        ("quantity = \"v(C) @ N [1]\"", "quantity = \"v(D) @ N [1]\""),
        ("vx = \"v(C) @ N [1]\"", "vx = \"v(C) @ N [7]\""),
        ("quantity = \"q\"\n", "quantity = \"q''\"\n"),
    ];
    check(
        &edited(&edits),
        &expect![[r#"
        error: there is no component `7`
          --> publication.toml:10:17
           |
        10 | vx = "v(C) @ N [7]"
           |                 ^
           |
           = help: components are 1, 2 and 3

        error: the model has no point `D`
          --> publication.toml:15:15
           |
        15 | quantity = "v(D) @ N [1]"
           |               ^
           |
           = help: known here: `O`, `P`, `C`

        error: `q''` is no parameter, coordinate, time derivative or speed
          --> publication.toml:53:13
           |
        53 | quantity = "q''"
           |             ^^^
           |
           = help: did you mean `q'`?"#]],
    );
}

#[test]
fn errors_in_formulas_stand_at_their_column() {
    let edits = [
        ("u1 + length*cos(q)*u2", "u1 + length*cos(q)*u2'''"),
        ("-g*bob\"]\nmatrix_ids", "-g*bob''\"]\nmatrix_ids"),
        ("T + 0*vx", "T + 0*vz"),
        ("\"I + m*length^2\"", "\"I + m*length^2)\""),
    ];
    check(
        &edited(&edits),
        &expect![[r#"
        error: this name has more than 2 primes
          --> publication.toml:16:31
           |
        16 | printed = "u1 + length*cos(q)*u2'''"
           |                               ^^^^^
           |
           = help: q1'' is the second derivative; there is no third here

        error: unknown name `vz`
          --> publication.toml:28:18
           |
        28 | printed = "T + 0*vz"
           |                  ^^
           |
           = help: did you mean `vx`?

        error: unexpected `)`
          --> publication.toml:36:74
           |
        36 | matrix = [["2*m", "m*length*cos(q)"], ["m*length*cos(q)", "I + m*length^2)"]]
           |                                                                          ^
           |
           = help: there is no `(` to close here

        error: unknown name `bob''`
          --> publication.toml:37:26
           |
        37 | right = ["bob*q'^2", "-g*bob''"]
           |                          ^^^^^
           |
           = help: a prime stands after coordinates and speeds only; `bob` is neither"#]],
    );
}

#[test]
fn a_name_of_the_model_is_not_declared_again() {
    let edits = [("T = \"T\"", "m = \"T\""), ("bob = ", "sin = "), ("s = \"sin(q)\"", "vx = \"sin(q)\"")];
    check(
        &edited(&edits),
        &expect![[r#"
        error: `vx` is declared twice
          --> publication.toml:5:1
           |
         5 | vx = "sin(q)"
           | ^^
           |
          ::: publication.toml:10:1
           |
        10 | vx = "v(C) @ N [1]"
           | -- first declared here
           |
           = help: rename one of the two

        error: `sin` is reserved
         --> publication.toml:6:1
          |
        6 | sin = "m*length*s"
          | ^^^
          |
          = help: choose another name: this one belongs to the expression language

        error: unknown name `s`
         --> publication.toml:6:17
          |
        6 | sin = "m*length*s"
          |                 ^
          |
          = help: known here: `m`, `length`, `I`, `g`, `x`, `x'`, `x''`, `q`, `q'`, `q''`, `u1`, `u1'`, `u2`, `u2'`, `rod_force_n1`, `rod_force_n2`, `cart_force_n2`, `vx`

        error: `m` is a parameter of the model
         --> publication.toml:9:1
          |
        9 | m = "T"
          | ^
          |
          = help: choose another name: in formulas `m` is the model's

        error: unknown name `T`
          --> publication.toml:28:12
           |
        28 | printed = "T + 0*vx"
           |            ^
           |
           = help: known here: `m`, `length`, `I`, `g`, `x`, `x'`, `x''`, `q`, `q'`, `q''`, `u1`, `u1'`, `u2`, `u2'`, `rod_force_n1`, `rod_force_n2`, `cart_force_n2`, `vx`

        error: unknown name `bob`
          --> publication.toml:37:11
           |
        37 | right = ["bob*q'^2", "-g*bob"]
           |           ^^^            --- also here, and 1 times more
           |
           = help: known here: `m`, `length`, `I`, `g`, `x`, `x'`, `x''`, `q`, `q'`, `q''`, `u1`, `u1'`, `u2`, `u2'`, `rod_force_n1`, `rod_force_n2`, `cart_force_n2`, `vx`"#]],
    );
}

#[test]
fn an_abbreviation_uses_those_above_it() {
    check_edit(
        "s = \"sin(q)\"",
        "s = \"sin(q) + bob\"",
        &expect![[r#"
        error: `bob` is used before it is declared
         --> publication.toml:5:15
          |
        5 | s = "sin(q) + bob"
          |               ^^^
          |
          = help: an abbreviation may use those above it"#]],
    );
}

#[test]
fn an_initial_value_is_a_number_and_stands_once_in_its_set() {
    let edits = [("10*pi/180", "10*m"), ("quantity = \"x'\"", "quantity = \"q\""), ("-0.250", "1e999")];
    check(
        &edited(&edits),
        &expect![[r#"
            error: `10*m` is not a number: it contains `m`
              --> publication.toml:54:12
               |
            54 | printed = "10*m"
               |            ^^^^
               |
               = help: write a number, or one in terms of numbers and `pi`

            error: `q` has two values in the set `text`
              --> publication.toml:60:13
               |
            60 | quantity = "q"
               |             ^
               |
              ::: publication.toml:53:13
               |
            53 | quantity = "q"
               |             - first stated here
               |
               = help: put what another place prints into a set of its own

            error: a number of about 10^999 is beyond double precision
              --> publication.toml:61:11
               |
            61 | printed = 1e999
               |           ^^^^^
               |
               = help: scale the quantity: numbers reach from 1e-307 to 1e308 in size"#]],
    );
}

/// A number beyond the range of doubles is refused: it cannot be computed, and exact arithmetic with it costs minutes.
#[test]
fn a_number_beyond_double_precision_is_refused() {
    check_edit(
        "s = \"sin(q)\"",
        "s = \"sin(q) - 1e999*cos(q)\"",
        &expect![[r#"
        error: a number of about 10^999 is beyond double precision
         --> publication.toml:5:6
          |
        5 | s = "sin(q) - 1e999*cos(q)"
          |      ^^^^^^^^^^^^^^^^^^^^^
          |
          = help: scale the quantity: numbers reach from 1e-307 to 1e308 in size"#]],
    );
}

#[test]
fn errors_in_latex_stand_at_their_column() {
    let symbols = "[symbols]\n'\\ell' = \"length\"\n\n[abbreviations]";
    let edits = [
        ("[abbreviations]", symbols),
        ("\"u1 + length*cos(q)*u2\"", "'u_1 + \\dots + \\ell \\cos(q) u_2'\nnotation = \"latex\""),
        ("\"T + 0*vx\"", "'T + \\beta length'\nnotation = \"latex\""),
    ];
    check(
        &edited(&edits),
        &expect![[r#"
        error: `\dots` is not known
          --> publication.toml:19:18
           |
        19 | printed = 'u_1 + \dots + \ell \cos(q) u_2'
           |                  ^^^^^
           |
           = help: write out what the dots stand for

        error: unknown symbol `\beta`
          --> publication.toml:32:16
           |
        32 | printed = 'T + \beta length'
           |                ^^^^^
           |
           = help: say in [symbols] what it stands for, as in '\beta' = "q1""#]],
    );
}

#[test]
fn what_is_wrong_with_symbols_and_notations_is_said() {
    let symbols = "notation = \"fortran\"\n[symbols]\n'\\ell' = \"lenght\"\n'a + b' = \"m\"\n'I_{x}' = \"I\"\n\"I_x\" = \"m\"\n\n[abbreviations]";
    check(
        &edited(&[("[abbreviations]", symbols)]),
        &expect![[r#"
        error: there is no notation `fortran`
         --> publication.toml:4:13
          |
        4 | notation = "fortran"
          |             ^^^^^^^
          |
          = help: known here: `tripos`, `latex`, `python`, `sympy`, `matlab`, `c`

        error: unknown name `lenght`
         --> publication.toml:6:11
          |
        6 | '\ell' = "lenght"
          |           ^^^^^^
          |
          = help: did you mean `length`?

        error: `a + b` is not a symbol
         --> publication.toml:7:1
          |
        7 | 'a + b' = "m"
          | ^^^^^^^
          |
          = help: a symbol is LaTeX, as in 'I_{xx}' or '\dot{\psi}', or a name of a program, as in Ixx, "p.m" or "z(6)"

        error: `I_x` is the same symbol as one that stands for `I`
         --> publication.toml:9:1
          |
        9 | "I_x" = "m"
          | ^^^^^
          |
          = help: remove one of the two"#]],
    );
}
