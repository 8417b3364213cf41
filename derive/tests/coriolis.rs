//! The matrix C of M(q) q̈ + C(q, q̇) q̇ + g(q) = τ: judged by C q̇, and by what the publication claims of it.
//!
//! Truth by hand: M. W. Spong, S. Hutchinson & M. Vidyasagar, *Robot Modeling and Control* (2006), §7.4, with point
//! masses at the ends of the links.

use crate::publications::load_text;
use std::path::Path;
use tripos_derive::Model;
use tripos_derive::diff::{Difference, judge_publication};
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;

fn judged(publication: &str) -> Difference {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../publications/two_link_arm/model.toml"));
    let mut model = Model::read(path).unwrap();
    let publication = load_text(publication, &mut model).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    judge_publication(&model, &mut derivations, &publication, &proof)
}

/// The verdicts of a matrix C with these claims, in words.
fn verdicts(matrix: &str, claims: &str) -> String {
    let text = format!(
        "notation = \"matlab\"\n[abbreviations]\nh = \"-m2*l1*l2*sin(theta2)\"\n[symbols]\nd1 = \"theta1'\"\nd2 = \"theta2'\"\n[[matrix]]\nid = \"C\"\nsection = \"1\"\nquantity = \"C\"\nprinted = \"{matrix}\"\nclaims = [{claims}]\n"
    );
    let words = |f: &tripos_derive::diff::Finding| format!("{} {}", f.id, f.judgement.word());
    judged(&text).findings.iter().map(words).collect::<Vec<_>>().join(", ")
}

#[test]
fn a_matrix_of_velocity_terms_is_judged_by_its_product_with_the_rates() {
    let christoffel = "[h*d2, h*(d1 + d2); -h*d1, 0]";
    assert_eq!(
        verdicts(christoffel, "\"christoffel\", \"skew-symmetric\""),
        "C-row1 equal, C-row2 equal, C-christoffel-11 equal, C-skew-11 equal, C-christoffel-12 equal, \
         C-skew-12 equal, C-christoffel-21 equal, C-christoffel-22 equal, C-skew-22 equal"
    );
    // Another matrix with the same product: right, but Ṁ − 2 C is not skew-symmetric.
    let other = "[2*h*d2, h*d2; -h*d1, 0]";
    assert_eq!(verdicts(other, ""), "C-row1 equal, C-row2 equal");
    assert_eq!(
        verdicts(other, "\"skew-symmetric\""),
        "C-row1 equal, C-row2 equal, C-skew-11 different, C-skew-12 different, C-skew-22 equal"
    );
    let wrong = "[h*d2, h*(d1 + d2); h*d1, 0]";
    assert_eq!(verdicts(wrong, ""), "C-row1 equal, C-row2 different");
}

#[test]
fn gravity_and_velocity_terms_are_quantities() {
    let entry = |id: &str, quantity: &str, printed: &str| {
        format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n")
    };
    let text = [
        entry("g1", "g[1]", "(m1 + m2)*g*l1*cos(theta1) + m2*g*l2*cos(theta1 + theta2)"),
        entry("g2", "g[theta2]", "m2*g*l2*cos(theta1 + theta2)"),
        entry("g2-wrong", "g[2]", "m2*g*l2*sin(theta1 + theta2)"),
        entry("h2", "h[2]", "m2*l1*l2*sin(theta2)*theta1'^2"),
        entry("rate", "Edot[1,2]", "-m2*l1*l2*sin(theta2)*theta2'"),
    ];
    let words: Vec<&str> = judged(&text.concat()).findings.iter().map(|f| f.judgement.word()).collect();
    assert_eq!(words, ["equal", "equal", "different", "equal", "equal"]);
}

#[test]
fn wrong_claims_are_reported() {
    let errors = |quantity: &str, printed: &str, claims: &str| {
        let text = format!(
            "notation = \"matlab\"\n[[matrix]]\nid = \"m\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\nclaims = {claims}\n"
        );
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../publications/two_link_arm/model.toml"));
        load_text(&text, &mut Model::read(path).unwrap()).map(|_| ()).unwrap_err().to_string()
    };
    assert!(errors("C", "[0, 0; 0, 0]", "[\"skew\"]").contains("there is no claim `skew`"));
    assert!(errors("C", "[0, 0, 0]", "[]").contains("C is a matrix of 1 by 3 for 2 coordinates"));
    assert!(errors("M", "[0, 0; 0, 0]", "[]").contains("`claims` on `M`"));
    assert!(errors("C", "[0, 0; 0, 0]", "\"skew-symmetric\"").contains("`claims` must be an array"));
}
