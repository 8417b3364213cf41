//! Root mistakes: groups that `diff` makes of repeated and inherited errors.

mod abbreviations;
mod planted;

use expect_test::expect;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{DependenceKind, Difference, judge_publication};
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;
use tripos_derive::{Model, publication};

/// A publication judged against a model; every entry that is different is in exactly one group.
fn judge(mut model: Model, source: &Source) -> Difference {
    let publication = publication::load_publication(source, &mut model).unwrap_or_else(|errors| panic!("{errors}"));
    judge_loaded(&model, &publication)
}

fn judge_loaded(model: &Model, publication: &publication::Publication) -> Difference {
    let mut derivations = derive_all(model).unwrap();
    let proof = prove(model, &mut derivations);
    let difference = judge_publication(model, &mut derivations, publication, &proof);
    let grouped: Vec<usize> = difference
        .roots
        .iter()
        .flat_map(|r| std::iter::once(r.finding).chain(r.followers.iter().map(|f| f.finding)))
        .collect();
    let findings = difference.findings.iter().enumerate();
    let wrong: BTreeSet<usize> =
        findings.filter(|(_, f)| f.judgement.word() == "different").map(|(at, _)| at).collect();
    assert_eq!(grouped.len(), wrong.len(), "no entry is in two groups");
    assert_eq!(grouped.into_iter().collect::<BTreeSet<_>>(), wrong);
    difference
}

fn disk(publication: &str) -> Difference {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let model = Model::read(&folder.join("../models/disk/model.toml")).unwrap();
    judge(model, &Source::read(&folder.join(publication)).unwrap())
}

/// Each root with its followers, a line each.
fn outline(difference: &Difference) -> String {
    let id = |at: &usize| difference.findings[*at].id.as_str();
    let ids = |list: &[usize]| list.iter().map(id).collect::<Vec<_>>().join(" + ");
    let mut out = String::new();
    for root in &difference.roots {
        let _ = writeln!(out, "{} ({})", root.title(&difference.findings), root.entries());
        for f in &root.followers {
            let also = if f.also.is_empty() { String::new() } else { format!(", also of {}", ids(&f.also)) };
            let _ = writeln!(out, "  {} {} {}{also}", id(&f.finding), f.link.words(), ids(&f.from));
        }
    }
    out
}

/// Truth by hand: the publication takes ω(B) for ω(C) in ω × H and carries it into Kane's second row, Euler's rows and
/// the program that solves them; its Lagrangian system has three wrong entries, which its program repeats.
#[test]
fn the_errors_of_the_course_report_come_of_few_mistakes() {
    let difference = disk("../models/disk/publication.toml");
    expect![[r"
        kane-3.2-line1-b1: omega(B) is printed instead of omega(C) in omega x H (17)
          kane-3.2-line1-b2 repeated kane-3.2-line1-b1
          kane-3.2-line3-b2 repeated kane-3.2-line1-b2
          kane-final-row2 follows kane-3.2-line3-b2
          newton-euler-3.2-left-b1 repeated kane-3.2-line1-b1
          newton-euler-3.2-left-b2 repeated kane-3.2-line3-b2
          newton-euler-final-row4 follows newton-euler-3.2-left-b1
          newton-euler-final-row5 follows newton-euler-3.2-left-b2
          listing-5.3-line41-T1 repeated newton-euler-3.2-left-b1
          listing-5.3-line41-T2 repeated newton-euler-3.2-left-b2
          listing-5.3-line69-row4 repeated newton-euler-final-row4
          listing-5.3-line70-row5 repeated newton-euler-final-row5
          listing-5.4-dz7 repeated kane-final-row2
          listing-5.6-dz6 follows listing-5.3-line69-row4
          listing-5.6-dz7 follows listing-5.3-line70-row5
          listing-5.6-dz9 follows newton-euler-final-row4 + newton-euler-final-row5
          listing-5.6-dz10 follows newton-euler-final-row4 + newton-euler-final-row5
        kane-3.2-line2-b1: I·alpha has the factor -1/M (3)
          kane-3.2-line2-b2 repeated kane-3.2-line2-b1
          kane-3.2-line2-b3 repeated kane-3.2-line2-b2
        kane-3.2-line3-b1: 3*u2*u3 should be 2*u2*u3 (1)
        kane-final-row1: in the right-hand side, the term -3*R*u2*u3 should be -2*R*u2*u3, the term -R*u2^2*tan(q2) should be -3*R*u2^2*tan(q2) (2)
          listing-5.4-dz6 repeated kane-final-row1
        lagrange-3.2: R*q2 should be R*q2'; q1'*cos(q1) should be q4'*cos(q1) (1)
        lagrange-3.6-q1: ∂/∂t is printed instead of d/dt (5)
          lagrange-3.6-q2 repeated lagrange-3.6-q1
          lagrange-3.6-q3 repeated lagrange-3.6-q2
          lagrange-3.6-q4 repeated lagrange-3.6-q3
          lagrange-3.6-q5 repeated lagrange-3.6-q4
        lagrange-final-row1: in the coefficient of q1'', R^2*(6 - 5*cos(q2)^2)/2 should be R*(6 - 5*cos(q2)^2)/4 (3)
          lagrange-3.8-E11 repeated lagrange-final-row1
          listing-5.5-E11 repeated lagrange-3.8-E11
        lagrange-final-row2: in the coefficient of q2'', 5*R^2/4 should be 5*R/4 (3)
          lagrange-3.8-E22 repeated lagrange-final-row2
          listing-5.5-E22 repeated lagrange-3.8-E22
        lagrange-final-row5: in the right-hand side, -R*q1'^2*cos(q1)*cos(q2) should be -R*q1'^2*cos(q1)*sin(q2) (3)
          lagrange-3.9-A5 repeated lagrange-final-row5
          listing-5.5-dz10 repeated lagrange-3.9-A5
        4.3-q1': the values of q1', q2', q3' and those of u1, u2, u3 are exchanged (7)
          4.3-q2' contradicts listing-5.7-qd20
          4.4-u1 contradicts 4.3-q2'
          4.4-u2 contradicts 4.3-q1'
          4.4-u3 contradicts 4.3-q1'
          listing-5.7-qd10 contradicts 4.3-q1'
          listing-5.7-qd20 contradicts 4.3-q2'
        listing-5.2-line23-v2: the term -u4*sin(q1)*cos(q1) should be -u4*sin(q1)*sin(q2) (1)
        listing-5.4-dz10: the term -2*R*u2*cos(q1)*sin(q2)*(1 + tan(q2)^2) should be -R*u2^2*cos(q1)*tan(q2)/cos(q2) (1)
        listing-5.7-I11: several components are wrong by the factor 1/R (3)
          listing-5.7-I22 repeated listing-5.7-I11
          listing-5.7-I33 repeated listing-5.7-I22
    "]].assert_eq(&outline(&difference));
}

/// Goal: groups are of meanings. Method: the same publication as LaTeX and MATLAB.
#[test]
fn the_notation_of_a_report_does_not_change_its_groups() {
    let (plain, typeset) = (disk("../models/disk/publication.toml"), disk("tests/publications/disk_latex.toml"));
    assert_eq!(outline(&plain), outline(&typeset));
}

/// Two slips that give equal differences in quantities that do not follow from one another are two roots.
#[test]
fn equal_differences_alone_prove_nothing() {
    let entry = |id: &str, quantity: &str, printed: &str| {
        format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n")
    };
    let text = entry("turn", "rotation(N, A) [1,1]", "-cos(q2)")
        + &entry("partial", "d v(P) @ N [1]/d u2", "l*cos(q2) - 2*cos(q2)");
    let difference = planted::judged(&text);
    assert_eq!(difference.roots.len(), 2, "{}", outline(&difference));
    assert!(difference.roots.iter().all(|root| root.followers_by_link(DependenceKind::Follows).count() == 0));
}

/// Checks that every line of a publication, made by hand from one wrong value, is traced to the first.
fn all_come_of_the_first(lines: &[(&str, &str)]) {
    let entry = |(quantity, printed): &(&str, &str)| {
        let id = quantity.replace(char::is_whitespace, "");
        format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n")
    };
    let lines_of = lines.iter().map(entry).collect::<String>();
    let difference = planted::judged(&lines_of);
    assert_eq!(difference.count("different"), lines.len(), "{}", outline(&difference));
    assert_eq!(difference.roots.len(), 1, "{}", outline(&difference));
}

/// Goal: the formulas of kinematics, each by hand. Method: l printed twice too long in one line, and put into those
/// below it; components in a frame that turns, so that a = dv/dt + ω × v.
#[test]
fn what_is_made_of_a_velocity_comes_of_it() {
    all_come_of_the_first(&[
        ("v(P) @ A [1]", "u1*cos(q2) + 2*l*u2"),
        ("a(P) @ A [1]", "u1'*cos(q2) + 2*l*u2'"),
        ("a(P) @ A [2]", "-u1'*sin(q2) + 2*l*u2^2"),
        ("d v(P) @ A [1]/d u2", "2*l"),
        ("F[2]", "-2*m*g*l*sin(q2)"),
        ("T_translation", "M*u1^2/2 + m*((u1*cos(q2) + 2*l*u2)^2 + u1^2*sin(q2)^2)/2"),
        ("energy", "M*u1^2/2 + m*((u1*cos(q2) + 2*l*u2)^2 + u1^2*sin(q2)^2)/2 + J*u2^2/2 - m*g*l*cos(q2)"),
    ]);
    all_come_of_the_first(&[("p(P) @ N [1]", "q1 + 2*l*sin(q2)"), ("v(P) @ N [1]", "u1 + 2*l*u2*cos(q2)")]);
    all_come_of_the_first(&[("q2'", "2*u2"), ("a(P) @ N [1]", "u1' + l*u2'*cos(q2) - 2*l*u2^2*sin(q2)")]);
}

/// Mistakes are traced through an angular velocity, an angular acceleration, and single entries of Kane's system.
#[test]
fn what_is_made_of_an_angular_velocity_comes_of_it() {
    all_come_of_the_first(&[
        ("omega(A) @ N [3]", "2*u2"),
        ("v(P) @ N [1]", "u1 + 2*l*u2*cos(q2)"),
        ("alpha(A) @ N [3]", "2*u2'"),
        ("H(rod) @ A [3]", "2*J*u2"),
        ("Hdot(rod) @ N [3]", "2*J*u2'"),
        ("T_rotation", "J*(2*u2)^2/2"),
    ]);
    all_come_of_the_first(&[
        ("alpha(A) @ N [3]", "2*u2'"),
        ("Tstar(rod) @ A [3]", "-2*J*u2'"),
        ("Fstar[2]", "-m*l*cos(q2)*u1' - m*l^2*u2' - 2*J*u2'"),
        ("M[2,2]", "m*l^2 + 2*J"),
    ]);
}

/// One wrong factor in two entries of an inertia is one mistake; two different factors are two.
#[test]
fn one_factor_in_several_entries_is_one_mistake_and_two_are_two() {
    let entry = |at: &str, factor: &str| {
        format!(
            "[[equation]]\nid = \"I{at}\"\nsection = \"1\"\nquantity = \"I(rod) @ A [{at},{at}]\"\nprinted = \"{factor}*J\"\n"
        )
    };
    let roots = |factors: [&str; 2]| {
        planted::judged(&(entry("1", factors[0]) + &entry("3", factors[1])))
            .roots
            .into_iter()
            .map(|r| r.mistake)
            .collect::<Vec<_>>()
    };
    assert_eq!(roots(["2*m", "2*m"]), ["several components are wrong by the factor 2*m"]);
    assert_eq!(roots(["2*m", "3*m"]), ["it is off by the factor 2*m", "it is off by the factor 3*m"]);
}
