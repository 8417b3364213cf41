//! Formulas that are printed near a point: linear equations, small angles, energies to second order.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::publications;

use expect_test::{Expect, expect};
use publications::{base, check, load_text};
use tripos_derive::diff::{Difference, judge_publication};
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;

fn judged(text: &str) -> Difference {
    let mut model = base();
    let publication = load_text(text, &mut model).unwrap_or_else(|errors| panic!("{errors}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    judge_publication(&model, &mut derivations, &publication, &proof)
}

/// Each finding: its id, the verdict, what is wrong and what else is said.
fn said(text: &str, expected: &Expect) {
    let difference = judged(text);
    let line = |f: &tripos_derive::diff::Finding| {
        let why = match &f.judgement {
            tripos_derive::diff::Judgement::Undecided(why) => format!(": {why}"),
            _ => String::new(),
        };
        let wrong = f.wrong.as_ref().map(|w| format!(" | {w}")).unwrap_or_default();
        let remarks = if f.remarks.is_empty() { String::new() } else { format!(" | {}", f.remarks.join("; ")) };
        format!("{} {}{why}{wrong}{remarks}\n", f.id, f.judgement.word())
    };
    expected.assert_eq(&difference.findings.iter().map(line).collect::<String>());
    assert!(difference.consequences.is_empty(), "what holds near a point is no equation of the whole motion");
}

/// The pendulum on a cart, hanging, as textbooks print it: 2 m ẍ + m l q̈ = 0, m l ẍ + (I + m l²) q̈ = −m g l q.
#[test]
fn linear_equations_are_right_about_their_point() {
    let text = |right: &str| {
        format!(
            r#"
            about = {{ x = 0, q = 0 }}
            [[system]]
            id = "linear"
            section = "1"
            formulation = "lagrange"
            unknowns = ["x''", "q''"]
            matrix = [["2*m", "m*length"], ["m*length", "I + m*length^2"]]
            right = [0, "{right}"]
            "#
        )
    };
    said(
        &text("-m*g*length*q"),
        &expect![[r"
        linear-row1 equal | to first order about x = 0, q = 0
        linear-row2 equal
    "]],
    );
    // Beyond first order anything may stand.
    said(
        &text("-m*g*length*(q + q^3 - q'^2)"),
        &expect![[r"
        linear-row1 equal | to first order about x = 0, q = 0
        linear-row2 equal
    "]],
    );
    said(
        &text("-2*m*g*length*q"),
        &expect![[r"
            linear-row1 equal | to first order about x = 0, q = 0
            linear-row2 different | in the right-hand side, -2*m*length*g*q should be -m*length*g*q | wrong: in the right-hand side, -2*m*length*g*q should be -m*length*g*q
        "]],
    );
}

/// To second order the factor m l cos(q) of q̈ is still m l, since q̈ is a deviation itself, and −m l q̇² sin(q) is of
/// third order.
#[test]
fn factors_of_deviations_count_to_one_order_less() {
    said(
        r#"
        about = { x = 0, q = 0 }
        order = 2
        [[system]]
        id = "second"
        section = "1"
        formulation = "lagrange"
        unknowns = ["x''", "q''"]
        matrix = [["2*m", "m*length"], ["m*length", "I + m*length^2"]]
        right = [0, "-m*g*length*q"]
        "#,
        &expect![[r"
            second-row1 equal | to second order about x = 0, q = 0
            second-row2 equal
        "]],
    );
}

/// About the upright place cos q = −1 and sin q = −(q − π).
#[test]
fn the_point_need_not_be_zero() {
    said(
        r#"
        about = { q = "pi" }
        [[system]]
        id = "upright"
        section = "1"
        formulation = "kane"
        unknowns = ["u1'", "u2'"]
        matrix = [["2*m", "-m*length"], ["-m*length", "I + m*length^2"]]
        right = [0, "m*g*length*(q - pi)"]

        [[equation]]
        id = "exact"
        section = "2"
        quantity = "v(C) @ N [1]"
        printed = "u1 + length*cos(q)*u2"
        about = {}
        "#,
        &expect![[r"
            upright-row1 equal | to first order about q = pi
            upright-row2 equal
            exact equal
        "]],
    );
}

/// Energies of linear equations are of second order: V = m g l q²/2 up to a constant, and T with the matrix at the
/// point.
#[test]
fn energies_are_stated_to_second_order() {
    said(
        r#"
        about = { x = 0, q = 0 }
        order = 2

        [[equation]]
        id = "V"
        section = "1"
        quantity = "V"
        printed = "m*g*length*q^2/2"

        [[equation]]
        id = "T"
        section = "1"
        quantity = "T"
        printed = "m*x'^2 + m*length*x'*q' + (I + m*length^2)*q'^2/2"

        [[equation]]
        id = "T-wrong"
        section = "1"
        quantity = "T"
        printed = "m*x'^2 + 2*m*length*x'*q' + (I + m*length^2)*q'^2/2"

        [[equation]]
        id = "v"
        section = "1"
        quantity = "v(C) @ N [1]"
        order = 1
        printed = "u1 + length*u2"
        "#,
        &expect![[r"
            V equal | the zero of the quantity is elsewhere: printed − derived = m*length*g, a constant; to second order about x = 0, q = 0
            T equal | to second order about x = 0, q = 0
            T-wrong different | the term 2*m*length*x'*q' should be m*length*x'*q' | the term 2*m*length*x'*q' should be m*length*x'*q'; to second order about x = 0, q = 0
            v equal | to first order about x = 0, q = 0
        "]],
    );
}

/// Formulas near a steady motion are judged to first order: from x' = v and q = 0 follow u1 = v and u2 = 0, and
/// products of deviations vanish.
#[test]
fn a_point_may_move() {
    let text = |v: &str| {
        format!(
            r#"
            about = {{ q = 0, "x'" = "sqrt(g*length)" }}
            [abbreviations]
            v = "sqrt(g*length)"
            [[equation]]
            id = "rates"
            section = "1"
            quantity = "T"
            printed = "m*v^2 + 2*m*{v}*(x' - v) + m*length*v*q'"
            [[equation]]
            id = "speeds"
            section = "1"
            quantity = "T"
            printed = "2*m*v*u1 - m*v^2 + m*length*{v}*u2"
            "#
        )
    };
    said(
        &text("v"),
        &expect![[r"
            rates equal | to first order about q = 0, x' = sqrt(length*g)
            speeds equal | to first order about q = 0, x' = sqrt(length*g)
        "]],
    );
    assert_eq!(judged(&text("(2*v)")).count("different"), 2);
}

/// Solved forms and programs hold near a point as systems do.
#[test]
fn solved_forms_and_programs_are_judged_to_the_order() {
    said(
        r#"
        about = { q = 0 }

        [[equation]]
        id = "solved"
        section = "1"
        quantity = "q''"
        printed = "-2*m*g*length*q/(2*(I + m*length^2) - m*length^2)"

        [[listing]]
        id = "code"
        section = "A"
        formulation = "kane"
        state = ["x", "q", "u1", "u2"]
        derivative = ["u1", "u2", 0, "-m*g*length*q"]
        matrix = [["2*m", "m*length"], ["m*length", "I + m*length^2"]]
        "#,
        &expect![[r"
            solved equal | to first order about q = 0
            code-dz1 equal | to first order about q = 0
            code-dz2 equal
            code-E11 equal
            code-E12 equal
            code-dz3 equal
            code-E21 equal
            code-E22 equal
            code-dz4 equal
        "]],
    );
}

/// A formula with a bend or without a value at the point has no series there.
#[test]
fn what_has_no_series_is_undecided() {
    said(
        r#"
        about = { q = 0 }

        [[equation]]
        id = "bend"
        section = "1"
        quantity = "v(C) @ N [1]"
        printed = "u1 + length*u2*(1 + abs(q))"

        [[equation]]
        id = "pole"
        section = "1"
        quantity = "v(C) @ N [1]"
        printed = "u1 + length*u2*q/sin(q)"
        "#,
        &expect![[r"
            bend undecided: it has a bend there, and no series to first order about q = 0 | to first order about q = 0
            pole undecided: it has no value there, and no series to first order about q = 0 | to first order about q = 0
        "]],
    );
}

#[test]
fn wrong_points_and_orders_are_refused() {
    let entry = "\n[[equation]]\nid = \"1\"\nsection = \"1\"\nquantity = \"T\"\nprinted = 0\n";
    check(
        &format!("order = 2{entry}"),
        &expect![[r#"
            error: `order` without a point that it is about
             --> publication.toml:1:9
              |
            1 | order = 2
              |         ^
              |
              = help: add the point, as in about = { q1 = 0 }, or what is small, as in small = ["epsilon"]"#]],
    );
    check(
        &format!("about = {{ q = 0 }}\norder = 0{entry}"),
        &expect![[r"
        error: `order` must be a whole number from 1 to 4
         --> publication.toml:2:9
          |
        2 | order = 0
          |         ^
          |
          = help: 1 for linear formulas, 2 for energies of linear equations"]],
    );
    check(
        &format!("about = {{ p = 0, q = \"2*u1\", m = 1 }}{entry}"),
        &expect![[r#"
        error: `p` is no coordinate, time derivative, speed or reaction
         --> publication.toml:1:11
          |
        1 | about = { p = 0, q = "2*u1", m = 1 }
          |           ^
          |
          = help: known here: `x`, `x'`, `q`, `q'`, `u1`, `u2`, `rod_force_n1`, `rod_force_n2`, `cart_force_n2`

        error: `u1` is no parameter: a point stays where it is
         --> publication.toml:1:23
          |
        1 | about = { p = 0, q = "2*u1", m = 1 }
          |                       ^^^^
          |
          = help: write numbers and parameters of the model

        error: `m` is no coordinate, time derivative, speed or reaction
         --> publication.toml:1:30
          |
        1 | about = { p = 0, q = "2*u1", m = 1 }
          |                              ^
          |
          = help: known here: `x`, `x'`, `q`, `q'`, `u1`, `u2`, `rod_force_n1`, `rod_force_n2`, `cart_force_n2`"#]],
    );
    check(
        &format!("about = \"q = 0\"{entry}"),
        &expect![[r#"
        error: `about` must be a table
         --> publication.toml:1:9
          |
        1 | about = "q = 0"
          |         ^^^^^^^
          |
          = help: write it as about = { q1 = 0, u3 = "w" }"#]],
    );
}

/// Truth by hand: with a small moment of inertia I, m² l⁴/(m l² − I) is I + m l² to first order, not to second.
#[test]
fn formulas_may_hold_to_an_order_in_small_parameters() {
    let text = |right: &str, more: &str| {
        format!(
            r#"
            small = ["I"]
            {more}
            [[equation]]
            id = "1"
            section = "1"
            quantity = "M[2,2]"
            printed = "{right}"
            "#
        )
    };
    let inverse = "m^2*length^4/(m*length^2 - I)";
    said(
        &text(inverse, ""),
        &expect![[r"
            1 equal | to first order about I = 0
        "]],
    );
    said(
        &text(inverse, "order = 2"),
        &expect![[r"
            1 different | the term -I^2/(m*length^2) is missing | the term -I^2/(m*length^2) is missing; to second order about I = 0
        "]],
    );
    check(
        &text("m", "").replace("[\"I\"]", "[\"q\"]"),
        &expect![[r#"
            error: `q` is no parameter
             --> publication.toml:2:23
              |
            2 |             small = ["q"]
              |                       ^
              |
              = help: known here: `m`, `length`, `I`, `g`"#]],
    );
}
