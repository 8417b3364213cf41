//! Publications in other coordinates than those of the model: they are found, and judged in them.
//!
//! The equations of the double pendulum are those of textbooks, with angles from the vertical; the model has the second
//! angle relative to the first link.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use expect_test::{Expect, expect};
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{CoordinateSearch, find_coordinates, judge_publication};
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::load;
use tripos_derive::prove::prove;
use tripos_derive::publication;

const DOUBLE: &str = r#"
name = "Double pendulum with a relative angle"
[parameters]
m1 = { unit = "kg", value = 1, positive = true }
m2 = { unit = "kg", value = 2, positive = true }
l1 = { unit = "m", value = 3, positive = true }
l2 = { unit = "m", value = 4, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
[coordinates]
theta1 = { unit = "rad" }
theta2 = { unit = "rad" }
[speeds]
w1 = "theta1'"
w2 = "theta2'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "theta1" }
B = { from = "A", axis = 3, angle = "theta2" }
[points]
P = { from = "O", frame = "A", position = [0, "-l1", 0] }
Q = { from = "P", frame = "B", position = [0, "-l2", 0] }
[particles]
p = { point = "P", mass = "m1" }
q = { point = "Q", mass = "m2" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

fn model() -> Model {
    load(&Source::from_text("model.toml", DOUBLE)).unwrap_or_else(|e| panic!("{e}"))
}

fn found(text: &str) -> CoordinateSearch {
    let mut model = model();
    let publication = publication::load_publication(&Source::from_text("publication.toml", text), &mut model);
    let publication = publication.unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap();
    find_coordinates(&model, &mut derivations, &publication).unwrap()
}

/// Lines of verdicts in a table of coordinates.
fn judged(text: &str, table: &[(String, String)]) -> String {
    let mut model = model();
    let source = Source::from_text("publication.toml", text);
    let publication =
        publication::load_publication_in_coordinates(&source, &mut model, table).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let difference = judge_publication(&model, &mut derivations, &publication, &proof);
    let lines = difference.findings.iter().map(|f| format!("{} {}\n", f.id, f.judgement.word()));
    lines.collect()
}

/// Words for a search, and the verdicts in the coordinates that were found.
fn check(text: &str, expected: &Expect) {
    let search = found(text);
    let mut out = format!("{} of {} right, {} before\n", search.most, search.compared, search.as_stated);
    for table in &search.best {
        for (name, formula) in table {
            out.push_str(&[name, " = ", formula, "\n"].concat());
        }
        out += &judged(text, table);
    }
    expected.assert_eq(&out);
}

fn entry(id: &str, rest: &str) -> String {
    format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\n{rest}\n")
}

/// Equations of textbooks in absolute angles from the vertical.
fn textbook() -> String {
    [
        entry("V", "quantity = \"V\"\nprinted = \"-(m1 + m2)*g*l1*cos(theta1) - m2*g*l2*cos(theta2)\""),
        entry(
            "T",
            "quantity = \"T\"\nprinted = \"(m1 + m2)*l1^2*theta1'^2/2 + m2*l2^2*theta2'^2/2 \
             + m2*l1*l2*theta1'*theta2'*cos(theta1 - theta2)\"",
        ),
        entry(
            "row1",
            "printed = \"(m1 + m2)*l1*theta1'' + m2*l2*theta2''*cos(theta1 - theta2) \
             + m2*l2*theta2'^2*sin(theta1 - theta2) + (m1 + m2)*g*sin(theta1) = 0\"",
        ),
        entry(
            "row2",
            "printed = \"l2*theta2'' + l1*theta1''*cos(theta1 - theta2) - l1*theta1'^2*sin(theta1 - theta2) \
             + g*sin(theta2) = 0\"",
        ),
    ]
    .concat()
}

#[test]
fn absolute_angles_are_found() {
    check(
        &textbook(),
        &expect![[r"
        4 of 4 right, 0 before
        theta2 = theta1 + theta2
        w2 = w1 + w2
        V equal
        T equal
        row1 scaled
        row2 scaled
    "]],
    );
}

#[test]
fn angles_from_another_axis_with_other_names_are_found() {
    // The angles are from the horizontal, the first is that of the outer link.
    let from_the_axis = textbook()
        .replace("sin(theta1)", "cos(theta1)")
        .replace("-(m1 + m2)*g*l1*cos(theta1)", "(m1 + m2)*g*l1*sin(theta1)");
    let text =
        from_the_axis.replace("sin(theta2)", "cos(theta2)").replace("- m2*g*l2*cos(theta2)", "+ m2*g*l2*sin(theta2)");
    let swapped = text.replace("theta1", "first").replace("theta2", "theta1").replace("first", "theta2");
    check(
        &swapped,
        &expect![[r"
        4 of 4 right, 0 before
        theta1 = theta1 - pi/2 + theta2
        w1 = w1 + w2
        theta2 = theta1 - pi/2
        w2 = w1
        V equal
        T equal
        row1 scaled
        row2 scaled
    "]],
    );
}

#[test]
fn a_wrong_term_stays_wrong_in_the_best_coordinates() {
    check(
        &textbook().replace("- l1*theta1'^2", "+ l1*theta1'^2"),
        &expect![[r"
        3 of 4 right, 0 before
        theta2 = theta1 + theta2
        w2 = w1 + w2
        V equal
        T equal
        row1 scaled
        row2 different
    "]],
    );
}

#[test]
fn solved_forms_and_listings_are_judged_in_the_coordinates_found() {
    // The zero of the first angle is upright. By symmetry, turned signs are as right.
    let text = [
        entry("V", "quantity = \"V\"\nprinted = \"(m1 + m2)*g*l1*cos(theta1) + m2*g*l2*cos(theta1 + theta2)\""),
        entry("rate", "quantity = \"w1\"\nprinted = \"theta1'\""),
        entry("M11", "quantity = \"M[1,1]\"\nprinted = \"(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(theta2)\""),
        "[[system]]\nid = \"eom\"\nsection = \"1\"\nformulation = \"lagrange\"\nunknowns = [\"theta1''\", \"theta2''\"]\n\
         matrix = [[\"(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(theta2)\", \"m2*l2^2 + m2*l1*l2*cos(theta2)\"], \
         [\"m2*l2^2 + m2*l1*l2*cos(theta2)\", \"m2*l2^2\"]]\n\
         right = [\"m2*l1*l2*sin(theta2)*(2*theta1'*theta2' + theta2'^2) + (m1 + m2)*g*l1*sin(theta1) + m2*g*l2*sin(theta1 + theta2)\", \
         \"-m2*l1*l2*sin(theta2)*theta1'^2 + m2*g*l2*sin(theta1 + theta2)\"]\n"
            .to_owned(),
        "[[listing]]\nid = \"code\"\nsection = \"1\"\nformulation = \"kane\"\nstate = [\"theta1\", \"theta2\", \"w1\", \"w2\"]\n\
         matrix = [[\"(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(theta2)\", \"m2*l2^2 + m2*l1*l2*cos(theta2)\"], \
         [\"m2*l2^2 + m2*l1*l2*cos(theta2)\", \"m2*l2^2\"]]\n\
         derivative = [\"w1\", \"w2\", \
         \"m2*l1*l2*sin(theta2)*(2*w1*w2 + w2^2) + (m1 + m2)*g*l1*sin(theta1) + m2*g*l2*sin(theta1 + theta2)\", \
         \"-m2*l1*l2*sin(theta2)*w1^2 + m2*g*l2*sin(theta1 + theta2)\"]\n"
            .to_owned(),
    ];
    check(
        &text.concat(),
        &expect![[r"
        8 of 8 right, 3 before
        theta1 = pi + theta1
        V equal
        rate equal
        M11 equal
        eom-row1 equal
        eom-row2 equal
        code-dz1 equal
        code-dz2 equal
        code-E11 equal
        code-E12 equal
        code-dz3 equal
        code-E21 equal
        code-E22 equal
        code-dz4 equal
    "]],
    );
    let turned = [("theta1", "pi - theta1"), ("theta2", "-theta2"), ("w1", "-w1"), ("w2", "-w2")];
    let turned = turned.map(|(name, formula)| (name.to_owned(), formula.to_owned()));
    expect![[r"
        V equal
        rate equal
        M11 equal
        eom-row1 equal
        eom-row2 equal
        code-dz1 equal
        code-dz2 equal
        code-E11 scaled
        code-E12 scaled
        code-dz3 scaled
        code-E21 scaled
        code-E22 scaled
        code-dz4 scaled
    "]]
    .assert_eq(&judged(&text.concat(), &turned));
}

/// Goal: a name of a derived quantity never stands for another coordinate than the author's. Method: it is refused.
#[test]
fn names_and_points_of_renamed_coordinates_are_refused() {
    let table = "[coordinates]\ntheta1 = \"-theta1\"\n";
    let texts = [
        format!("{table}[names]\nacc = \"theta1''\"\n{}", entry("1", "quantity = \"V\"\nprinted = \"acc\"")),
        format!("about = {{ theta1 = 0 }}\n{table}{}", entry("1", "quantity = \"V\"\nprinted = \"0\"")),
        format!(
            "[coordinates]\ntheta1 = \"theta1 + theta2\"\n{}",
            entry("1", "quantity = \"theta1''\"\nprinted = \"0\"")
        ),
    ];
    for text in texts {
        let source = Source::from_text("publication.toml", &text);
        assert!(publication::load_publication(&source, &mut model()).is_err(), "{text}");
    }
}

#[test]
fn right_equations_need_no_other_coordinates() {
    let text = entry("V", "quantity = \"V\"\nprinted = \"-(m1 + m2)*g*l1*cos(theta1) - m2*g*l2*cos(theta1 + theta2)\"");
    check(
        &text,
        &expect![[r"
        1 of 1 right, 1 before
    "]],
    );
}

#[test]
fn coordinates_of_the_publication_are_changed_too() {
    let text = format!("[coordinates]\nalpha = \"theta1\"\nbeta = \"theta2\"\n{}", textbook());
    check(
        &text
            .replace("theta1'", "alpha'")
            .replace("theta2'", "beta'")
            .replace("(theta1", "(alpha")
            .replace("(theta2", "(beta")
            .replace("- theta2", "- beta"),
        &expect![[r"
            4 of 4 right, 0 before
            theta2 = theta1 + theta2
            w2 = w1 + w2
            alpha = theta1
            beta = theta1 + theta2
            V equal
            T equal
            row1 scaled
            row2 scaled
        "]],
    );
}
