//! Mistakes planted in a right derivation, some of them carried into later lines, must be found again.

use super::{judge, outline};
use std::collections::BTreeSet;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::Difference;
use tripos_derive::model;

/// A rod on a cart: mass m, length l to the mass centre, central inertia J.
const CART: &str = r#"
name = "Rod on a cart"
[parameters]
M = { unit = "kg", positive = true }
m = { unit = "kg", positive = true }
l = { unit = "m", positive = true }
J = { unit = "kg*m^2", positive = true }
g = { unit = "m/s^2", positive = true }
[coordinates]
q1 = { unit = "m" }
q2 = { unit = "rad" }
[speeds]
u1 = "q1'"
u2 = "q2'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q2" }
[points]
B = { from = "O", frame = "N", position = ["q1", 0, 0] }
P = { from = "B", frame = "A", position = [0, "-l", 0] }
[particles]
cart = { point = "B", mass = "M" }
[bodies.rod]
frame = "A"
centre = "P"
mass = "m"
inertia = { frame = "A", diagonal = ["J", "J", "J"] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

pub fn judged(publication: &str) -> Difference {
    let model = model::load(&Source::from_text("cart.toml", CART)).unwrap_or_else(|e| panic!("{e}"));
    judge(model, &Source::from_text("publication.toml", publication))
}

/// A coefficient that is 1 where the derivation is right, and the id of the line in which it is made.
const SITES: [&str; 5] = ["a1", "J", "W", "Tt", "V"];

/// A line of a derivation: its id, the sites whose mistakes it may inherit, and its printed text with coefficients K
/// of these sites, in their order. Derived by hand for any values of the coefficients.
type Line = (&'static str, &'static [usize], fn(&[&str]) -> String);

/// The derivation.
fn lines() -> [Line; 15] {
    [
        ("a1", &[0], |k| equation("a1", "a(P) @ N [1]", &format!("u1' + l*u2'*cos(q2) - {}*l*u2^2*sin(q2)", k[0]))),
        ("a2", &[], |_| equation("a2", "a(P) @ N [2]", "l*u2'*sin(q2) + l*u2^2*cos(q2)")),
        ("R1", &[0], |k| {
            equation("R1", "Rstar(rod) @ N [1]", &format!("-m*(u1' + l*u2'*cos(q2) - {}*l*u2^2*sin(q2))", k[0]))
        }),
        ("J", &[1], |k| equation("J", "I(rod) @ A [3,3]", &format!("{}*J", k[0]))),
        ("T3", &[1], |k| equation("T3", "Tstar(rod) @ A [3]", &format!("-{}*J*u2'", k[0]))),
        ("Fs1", &[0], |k| {
            equation("Fs1", "Fstar[1]", &format!("-M*u1' - m*(u1' + l*u2'*cos(q2) - {}*l*u2^2*sin(q2))", k[0]))
        }),
        ("Fs2", &[0, 1], |k| {
            let a1 = format!("u1' + l*u2'*cos(q2) - {}*l*u2^2*sin(q2)", k[0]);
            let a2 = "l*u2'*sin(q2) + l*u2^2*cos(q2)";
            let printed = format!("-m*l*cos(q2)*({a1}) - m*l*sin(q2)*({a2}) - {}*J*u2'", k[1]);
            equation("Fs2", "Fstar[2]", &printed)
        }),
        ("W", &[2], |k| equation("W", "weight(rod) @ N [2]", &format!("-{}*m*g", k[0]))),
        ("F2", &[2], |k| equation("F2", "F[2]", &format!("-{}*m*g*l*sin(q2)", k[0]))),
        ("kane-row2", &[0, 1, 2], |k| {
            let right = format!("-{}*m*g*l*sin(q2) + ({} - 1)*m*l^2*u2^2*sin(q2)*cos(q2)", k[2], k[0]);
            system("kane", "u", &["m*l*cos(q2)", &format!("m*l^2 + {}*J", k[1]), &right], "m*l*u2^2*sin(q2)")
        }),
        ("Tt", &[3], |k| {
            let printed = format!("M*u1^2/2 + m*(u1^2 + 2*{}*l*u1*u2*cos(q2) + l^2*u2^2)/2", k[0]);
            equation("Tt", "T_translation", &printed)
        }),
        ("T", &[3], |k| {
            let printed = format!("M*u1^2/2 + m*(u1^2 + 2*{}*l*u1*u2*cos(q2) + l^2*u2^2)/2 + J*u2^2/2", k[0]);
            equation("T", "T", &printed)
        }),
        ("V", &[4], |k| equation("V", "V", &format!("-{}*m*g*l*cos(q2)", k[0]))),
        ("L", &[3, 4], |k| {
            let t = format!("M*u1^2/2 + m*(u1^2 + 2*{}*l*u1*u2*cos(q2) + l^2*u2^2)/2 + J*u2^2/2", k[0]);
            equation("L", "L", &format!("{t} + {}*m*g*l*cos(q2)", k[1]))
        }),
        ("lagrange-row2", &[3, 4], |k| {
            let right = format!("-{}*m*g*l*sin(q2)", k[1]);
            system("lagrange", "q", &[&format!("{}*m*l*cos(q2)", k[0]), "m*l^2 + J", &right], "m*l*q2'^2*sin(q2)")
        }),
    ]
}

fn equation(id: &str, quantity: &str, printed: &str) -> String {
    format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n")
}

/// Both rows, of which the first is right.
fn system(formulation: &str, variable: &str, second: &[&str; 3], right: &str) -> String {
    let dots = if variable == "u" { "'" } else { "''" };
    let [a, b, c] = second;
    format!(
        "[[system]]\nid = \"{formulation}\"\nsection = \"1\"\nformulation = \"{formulation}\"\n\
         unknowns = [\"{variable}1{dots}\", \"{variable}2{dots}\"]\n\
         matrix = [[\"M + m\", \"m*l*cos(q2)\"], [\"{a}\", \"{b}\"]]\nright = [\"{right}\", \"{c}\"]\n"
    )
}

/// Numbers that are the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from((self.0 >> 33) % sides).unwrap()
    }
}

/// Goal: roots are where mistakes were made, and followers are traced to exactly those that they inherit. Method: 12
/// derivations with random mistakes, each later line inheriting or not at random; a line that inherits nothing is
/// right.
#[test]
fn planted_mistakes_are_found_with_all_that_inherits_them() {
    let mut inherited = 0;
    for seed in 0..12 {
        let mut dice = Dice(seed * 7919 + 1);
        let values: Vec<&str> = SITES.iter().map(|_| ["1", "1", "2", "3", "(1/2)"][dice.roll(5)]).collect();
        let mut text = String::new();
        let mut expected = Vec::new();
        for (id, sites, print) in lines() {
            let keeps: Vec<bool> = sites.iter().map(|site| id == SITES[*site] || dice.roll(3) > 0).collect();
            let printed: Vec<&str> =
                sites.iter().zip(&keeps).map(|(site, kept)| if *kept { values[*site] } else { "1" }).collect();
            text += &print(&printed);
            let wrong = sites.iter().zip(&printed).filter(|(_, value)| **value != "1");
            let of: BTreeSet<&str> = wrong.map(|(site, _)| SITES[*site]).collect();
            if !of.is_empty() {
                expected.push((id, of));
            }
        }
        let difference = judged(&text);
        assert_eq!(found(&difference), expected, "seed {seed}\n{}\n{text}", outline(&difference));
        inherited += expected.iter().filter(|(id, _)| !SITES.contains(id)).count();
    }
    assert!(inherited > 20, "{inherited}: the derivations inherit something");
}

/// Each wrong entry with the roots that it comes of, in the order of the file.
fn found(difference: &Difference) -> Vec<(&str, BTreeSet<&str>)> {
    let id = |at: usize| difference.findings[at].id.as_str();
    let mut list: Vec<(usize, BTreeSet<&str>)> = Vec::new();
    for root in &difference.roots {
        list.push((root.finding, BTreeSet::from([id(root.finding)])));
        for f in &root.followers {
            let own = std::iter::once(root.finding).chain(f.also.iter().copied()).map(id);
            list.push((f.finding, own.collect()));
        }
    }
    list.sort();
    list.into_iter().map(|(at, of)| (id(at), of)).collect()
}
