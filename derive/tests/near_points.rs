//! Formulas that are printed near a point: linear equations, small angles, energies to second order.

use crate::reports;

use expect_test::{Expect, expect};
use reports::{base, check, load_text};
use tripos_derive::diff::{Difference, diff};
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;

fn judged(text: &str) -> Difference {
    let mut model = base();
    let report = load_text(text, &mut model).unwrap_or_else(|errors| panic!("{errors}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    diff(&model, &mut derivations, &report, &proof)
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
        format!("{} {}{why}{wrong} | {}\n", f.id, f.judgement.word(), f.remarks.join("; "))
    };
    expected.assert_eq(&difference.findings.iter().map(line).collect::<String>());
    assert!(difference.consequences.is_empty(), "what holds near a point is no equation of the whole motion");
}

/// Of the pendulum on a cart as textbooks print it, hanging: 2 m ẍ + m l q̈ = 0, m l ẍ + (I + m l²) q̈ = −m g l q.
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
    said(&text("-m*g*length*q"), &expect![[""]]);
    // Beyond first order anything may stand.
    said(&text("-m*g*length*(q + q^3 - q'^2)"), &expect![[""]]);
    said(&text("-2*m*g*length*q"), &expect![[""]]);
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
        &expect![[""]],
    );
}

/// Energies of linear equations are of second order: V = m g l q²/2 up to a constant, and T with the matrix at the point.
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
        &expect![[""]],
    );
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
        &expect![[""]],
    );
}

/// What has a bend or no value at the point has no series there.
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
        &expect![[""]],
    );
}

#[test]
fn wrong_points_and_orders_are_refused() {
    let entry = "\n[[equation]]\nid = \"1\"\nsection = \"1\"\nquantity = \"T\"\nprinted = 0\n";
    check(&format!("order = 2{entry}"), &expect![[""]]);
    check(&format!("about = {{ q = 0 }}\norder = 0{entry}"), &expect![[""]]);
    check(&format!("about = {{ p = 0, q = \"2*u1\", m = 1 }}{entry}"), &expect![[""]]);
    check(&format!("about = \"q = 0\"{entry}"), &expect![[""]]);
}
