//! Where mechanisms are singular, and what is said of their assembly branches, by `tripos check`.
//!
//! Truth: closed forms. A four-bar linkage has a singular pose exactly if its bars can lie in a line, a ± b ± c ± d = 0 (Grashof's equality;
//! J. J. Uicker, G. R. Pennock & J. E. Shigley, *Theory of Machines and Mechanisms*, 5th edition (2017), § 1.9).

use crate::common::read;
use std::path::Path;
use tripos_derive::check::{Check, check};

fn of_library(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).join("model.toml");
    std::fs::read_to_string(path).unwrap()
}

fn checked(text: &str) -> Check {
    let model = read(text).unwrap_or_else(|e| panic!("{e}"));
    check(&model).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)))
}

/// The linkage of the library with other lengths: crank, coupler, rocker, ground.
fn four_bar(lengths: [f64; 4]) -> Check {
    let mut text = of_library("four_bar");
    for ((name, old), new) in [("a", "0.3"), ("b", "0.8"), ("c", "0.6"), ("d", "0.7")].iter().zip(lengths) {
        let stated = format!("\n{name} = {{ unit = \"m\", value = {old},");
        assert!(text.contains(&stated));
        text = text.replace(&stated, &format!("\n{name} = {{ unit = \"m\", value = {new:?},"));
    }
    checked(&text)
}

#[test]
fn linkages_that_can_lie_in_a_line_are_singular_there() {
    // A parallelogram, a kite, and a bar as long as the others together less one.
    for lengths in [[0.3, 0.7, 0.3, 0.7], [0.4, 0.4, 0.7, 0.7], [0.3, 0.8, 0.6, 0.5]] {
        let found = four_bar(lengths);
        let loss = found.rank_loss.unwrap();
        let pose = loss.pose.unwrap_or_else(|| panic!("{lengths:?}"));
        let names: Vec<&str> = pose.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["q1", "q2", "q3"]);
        let [a, b, c, d] = lengths;
        let along = pose[0].1.cos() * a + pose[1].1.cos() * b - pose[2].1.cos() * c - d;
        assert!(along.abs() < 1e-9, "{pose:?}");
        // 1e-5: closing is of second order there.
        assert!(pose.iter().all(|(_, q)| q.sin().abs() < 1e-5), "{lengths:?}: {pose:?}");
    }
}

/// Goal: a driven linkage is singular where its coupler and its rocker come to lie in a line, whenever that is. Method: the distance of the pins that the
/// crank and the ground hold, a² + d² − 2 a d cos q1 = (b ± c)², at q1 = 1.2 + w t, which is no singular pose at t = 0.
#[test]
fn a_driven_linkage_is_singular_at_some_instant() {
    let driven = |b: f64, c: f64| {
        let text = of_library("four_bar");
        let text = text
            .replace("[speeds]\nu1 = \"q1'\"\n", "")
            .replace("[constraints]\n", "[constraints]\nmotor = { equation = \"q1 = 1.2 + w*t\" }\n");
        let text =
            text.replace("\n[coordinates]", "w = { unit = \"1/s\", value = 0.5, positive = true }\n\n[coordinates]");
        let text = text.replace("a = { unit = \"m\", value = 0.3", "a = { unit = \"m\", value = 0.6");
        let text = text.replace("b = { unit = \"m\", value = 0.8", &format!("b = {{ unit = \"m\", value = {b:?}"));
        let text = text.replace("c = { unit = \"m\", value = 0.6", &format!("c = {{ unit = \"m\", value = {c:?}"));
        let reactions = text.find("[reactions.").unwrap();
        let text =
            text[..reactions].replace(", enforced_by = \"pin_qx\"", "").replace(", enforced_by = \"pin_qy\"", "");
        checked(&text)
    };
    let loss = driven(0.8, 0.3).rank_loss.unwrap();
    let pose = loss.pose.expect("the crank brings them into a line");
    let of = |name: &str| pose.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("{name}: {pose:?}")).1;
    let square = 0.85 - 0.84 * (1.2 + 0.5 * of("t")).cos();
    assert!(of("t") >= 0.0 && (square - 1.21).abs().min((square - 0.25).abs()) < 1e-8, "{pose:?}");
    assert!((of("q2") - of("q3")).sin().abs() < 1e-4, "{pose:?}");
    // The pins are 0.1 to 1.3 apart: more than the bars differ by, less than both together.
    let free = driven(0.8, 0.75).rank_loss.unwrap();
    assert!(free.pose.is_none() && free.sought >= 3, "{:?}", free.pose);
}

#[test]
fn other_linkages_fail_only_by_the_choice_of_speeds() {
    let found = four_bar([0.3, 0.8, 0.6, 0.7]);
    assert_eq!(found.singular_where, ["sin(q2 - q3)"]);
    let loss = found.rank_loss.unwrap();
    assert_eq!((loss.rank, loss.nowhere, loss.pose), (2, false, None));
    assert!(loss.sought >= 10);
    let mut formulas = loss.where_all_zero.unwrap();
    formulas.sort();
    assert_eq!(formulas, ["sin(q1 - q2)", "sin(q1 - q3)", "sin(q2 - q3)"]);
}

#[test]
fn rolling_is_regular_whatever_fails_of_the_speeds() {
    let found = checked(&of_library("rolling_disc"));
    assert_eq!(found.singular_where, ["cos(q2)"]);
    let loss = found.rank_loss.unwrap();
    assert_eq!((loss.rank, loss.nowhere, loss.pose), (2, true, None));
    assert_eq!(found.branch, None);
    // Nothing ties a pendulum.
    assert_eq!(checked(&of_library("pendulum")).rank_loss, None);
}

/// Goal: what is known since 1897. One pin of six is the ground's, so that five coordinates and the five equations of the last pin are
/// left: five of six screws are independent, four of five equations.
#[test]
fn bricards_mechanism_moves_though_counting_says_that_it_does_not() {
    let found = checked(&of_library("bricard"));
    assert_eq!((found.mobility_count, found.degrees_of_freedom), (0, 1));
    let branch = found.branch.unwrap();
    assert_eq!((branch.rank, branch.constraints, branch.pose.len()), (4, 5, 5));
    assert!(branch.independent > 1e-6 && branch.dependent.unwrap() < 1e-8, "{branch:?}");
    assert_eq!(found.constraints.iter().filter(|c| c.redundant).count(), 1);
    assert!(found.notes.iter().any(|note| note.contains("follows from")), "{:?}", found.notes);
}

#[test]
fn a_rod_without_inertia_about_itself_is_named() {
    let found = checked(
        "name = \"rod\"\n[parameters]\nm = { unit = \"kg\", value = 1 }\nJ = { unit = \"kg*m^2\", value = 1 }\n[coordinates]\nq = { unit = \"rad\" }\ns = { \
         unit = \"rad\" }\n[speeds]\nu = \"q'\"\nw = \"s'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[frames]\nA = { from = \"N\", axis = 3, angle = \
         \"q\" }\nB = { from = \"A\", axis = 1, angle = \"s\" }\n[bodies.rod]\nframe = \"B\"\ncentre = \"O\"\nmass = \"m\"\ninertia = { diagonal = [0, \
         \"J\", \"J\"] }\n",
    );
    assert_eq!(found.indeterminate, ["w"]);
    assert_eq!(found.notes[0], "`rod` has no inertia about the axis that `w` turns it about");
}
