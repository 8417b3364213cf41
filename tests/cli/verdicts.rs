//! Publications with one mistake each, or none, and what `tripos diff` says of them.
//!
//! Each folder of `tests/data/verdicts` has a model and a publication that testers wrote. The right answers come from
//! SymPy and from derivations by hand.

use crate::support::{root, tripos_in};

/// A folder, the number of root mistakes, and what the answer says.
struct Case {
    folder: &'static str,
    roots: usize,
    says: &'static [&'static str],
}

const fn case(folder: &'static str, roots: usize, says: &'static [&'static str]) -> Case {
    Case { folder, roots, says }
}

const CASES: [Case; 79] = [
    // The sign of a multiplier in one system holds for its value below.
    case("03", 0, &["0 different"]),
    case("37", 1, &["the term 2*t1*cos(phi)/R should be 2*t1*cos(phi)/(3*R)"]),
    // The multipliers are those with plain signs, so that row 1 is wrong.
    case("04", 1, &["mult-row1", "-l*cos(theta) should be -r*cos(theta)"]),
    // Equations that are solved for one unknown.
    case("05", 1, &["in left − right, -m*a*w*v/IA should be m*a*w*v/IA"]),
    case("06", 1, &["the term -r'*theta'/r should be -2*r'*theta'/r"]),
    case("07", 1, &["it is off by the factor 1/2"]),
    case("08", 1, &["the term -m*l*om^2*sin(theta)/4 should be -m*l*om^2*sin(theta)/2"]),
    case("09", 1, &["tau should be -tau"]),
    case("b04", 1, &["m*g*sin(alpha) should be m*g*cos(alpha)"]),
    case("10", 1, &["m1 should be 2*m1"]),
    case("27", 1, &["v0*theta'/l should be 2*v0*theta'/l"]),
    case("32", 0, &["2 scaled"]),
    // Near a point: products with small parameters, and mistakes as printed.
    case("11", 1, &["the term -2*Om*y'*sin(lam) should be 2*Om*y'*sin(lam)"]),
    case("14", 1, &["-mb*l should be mb*l"]),
    case("15", 1, &["a*k1 should be a^2*k1", "b*k2 should be b^2*k2"]),
    // Abbreviations and variables of programs, named once.
    case("12", 1, &["T, 6 entries", "in I0, the term mr*l^2 is missing"]),
    // A product of a matrix and a vector, assigned to a range.
    case("29", 0, &["7 equal"]),
    case("13", 1, &["3 entries", "in b, Jw should be Jb"]),
    case("20", 1, &["in M11, h2*c23 should be 2*h2*c23"]),
    case("39", 1, &["2 entries", "in r1,"]),
    case("40", 1, &["2 entries", "in h, m2*l1*l2*cos(q2) should be m2*l1*l2*sin(q2)"]),
    case("41", 1, &["2 entries", "in r1, q1' should be 2*q1'"]),
    case("42", 1, &["b*r1 should be -b*r1"]),
    case("tc17", 1, &["2 entries", "in cd, cos(th1 + th2) should be cos(th1 - th2)"]),
    case("tc25", 1, &["2 entries", "in sd, cos(dl) should be sin(dl)"]),
    // A row solved for an acceleration that follows from a wrong energy.
    case("crane", 1, &["T, 3 entries", "the term m*l*x'*theta'*cos(theta) is missing"]),
    // A multiplier that the author has eliminated.
    case("ta23", 1, &["s-row2, 1 entry", "m*a*x''*sin(phi) should be -m*a*x''*sin(phi)"]),
    // One mistake in several entries of a row, or of a matrix with what is claimed of it.
    case("16", 1, &["C-row2, 3 entries"]),
    case("17", 1, &["-m*r*theta''^2 should be -m*r*theta'^2", "8 equal"]),
    case("18", 1, &["m*R*theta''^2 should be m*R*theta'^2"]),
    case("23", 1, &["-m*d*x'*sin(theta) should be -m*d*x''*sin(theta)"]),
    case("24", 1, &["-theta'*sin(theta) should be -theta'^2*sin(theta)"]),
    // A dot too many in a row that is divided by m, and a term on the right.
    case("c16", 1, &["r*theta''^2 should be"]),
    case("q08", 1, &["in left − right, -Nb*sin(alpha) should be Nb*sin(alpha)"]),
    // Right up to a constant on the constraints, in numbers up to a factor or a constant, and near a point.
    case("s05", 0, &["1 equal, 2 scaled"]),
    case("s04", 0, &["0 different"]),
    case("s02", 0, &["0 different"]),
    case("r13", 0, &["2 equal"]),
    case("r19", 0, &["0 different"]),
    // One step, an energy with another zero, and a factor on the constraints.
    case("19", 1, &["m2*l2*g*sin(q2) should be m2*l2*g*sin(q2 + q1)"]),
    case("21", 1, &["pth^2/(2*m*r) should be pth^2/(2*m*r^2)"]),
    case("26", 1, &["it is off by the factor 1/(R - r)"]),
    // The square of a bracket is lost, whose terms are then terms of the sum around it.
    case("25", 1, &["w2*(e - R*cos(theta)) + R*w3*sin(theta) should be (w2*(e - R*cos(theta)) + R*w3*sin(theta))^2"]),
    // Right up to a constant on the constraint; combinations of rows with multipliers of their own; with the potential
    // of a driven spring, which the model states as a force.
    case("j15", 0, &["up to a constant"]),
    case("j06", 0, &["2 equal, 2 scaled", "(1) row 1 + (1) row 3"]),
    case("g06", 0, &["2 equal", "with the potential of a load"]),
    // A rate of a function in other units is no part of an energy.
    case("d07", 1, &["the term M*l*theta'*cos(theta) should not be there", "units alone show it"]),
    // Constants beside a mistake; the author's own coordinates; multipliers that are turned.
    case("d04", 1, &["m*l*x'*theta'*sin(theta) should be m*l*x'*theta'*cos(theta)"]),
    case("m13", 1, &["the printed theta is pi - theta"]),
    case("m03", 1, &["m2*l1*l2*theta1'^2*sin(theta1 - theta2) should be -m2*l1*l2*theta1'^2*sin(theta1 - theta2)"]),
    case("c27", 1, &["s-row2, 1 entry", "cos(phi) should be -cos(phi)"]),
    case("i02", 1, &["s-row1, 1 entry", "(x2 - x1)/l2 should be (x1 - x2)/l2"]),
    case("c26", 1, &["m*R*theta'^2 should be m*R*theta'*phi'"]),
    // Mistakes in abbreviations, named once, and one abbreviation for another.
    case("l07", 1, &["s-row1, 3 entries", "sin(q2 - q3) should be sin(q2 + q3)"]),
    case("p23", 1, &["2 entries", "in k, h*s/2 should be h*s"]),
    case("h23", 1, &["4 entries", "in a12, -m2*l1*l2*cos(d) should be m2*l1*l2*cos(d)"]),
    case("a08", 1, &["2 entries", "in D, m*cos(theta)^2 should be m*sin(theta)^2"]),
    case("h21", 2, &["s-row1, 3 entries", "in b1,", "in b2,"]),
    case("f19", 1, &["-a*n1 should be -b*n1"]),
    // Multipliers are the author's in all entries alike, whether these are systems or single equations, and wherever
    // the value of one stands. What no choice of multipliers makes right is wrong.
    case("tg10", 1, &["a should be -a"]),
    case("tg12", 1, &["1 should be 2"]),
    case("tg31", 1, &["-y should be y"]),
    case("tg25", 1, &["r1, 1 entry"]),
    case("ta2d", 1, &["in the coefficient of phi'', the term m should not be there"]),
    case("tf06", 1, &["in the coefficient of phi'', the term m*a should not be there"]),
    case("tf30", 0, &["2 equal, 1 scaled"]),
    case("tf20", 0, &["2 equal"]),
    case("ta39", 0, &["1 equal, 1 scaled"]),
    case("tf15", 0, &["2 equal, 1 scaled"]),
    case("te4osums", 0, &["2 equal, 6 scaled"]),
    case("tg084", 1, &["s-row3, 1 entry"]),
    // Potentials of all loads beside a damper, of some loads, and up to a constant on the constraint.
    case("tb07", 0, &["with the potential of a load"]),
    case("tb0a", 0, &["with the potential of a load"]),
    case("tb34", 0, &["with the potential of a load"]),
    // An abbreviation that a right row uses is not blamed, even if the row has a factor.
    case("tc1b", 1, &["the term cd*a4*th1'^2 should be m2*l1*th1'^2*sin(th1 - th2)"]),
    case("tb3a", 0, &["with the potential of a load"]),
    case("tb17", 0, &["with the potential of a load"]),
    case("tb16", 1, &["units alone show it"]),
    // A factor in front of a matrix, and a transpose; the second entry of the vector has the other sign.
    case("tfactor", 1, &["5 equal, 0 scaled, 1 different", "it is off by the factor -1", "m*l*(g*sin(theta))"]),
];

/// Status and whole answer of `tripos diff` on a folder.
fn judged(folder: &str) -> (i32, String) {
    let (status, text, err) =
        tripos_in(&root().join("tests/data/verdicts").join(folder), &["diff", "model.toml", "publication.toml"]);
    (status, text + &err)
}

#[test]
fn single_mistakes_are_named_and_right_publications_acquitted() {
    let mut wrong = Vec::new();
    for Case { folder, roots, says } in &CASES {
        let (status, said) = judged(folder);
        let counted = match roots {
            0 => status == 0,
            1 => status == 1 && said.contains("1 root mistake behind"),
            n => said.contains(&format!("{n} root mistakes")),
        };
        let missing: Vec<_> = says.iter().filter(|part| !said.contains(**part)).collect();
        if !counted || !missing.is_empty() {
            wrong.push(format!("{folder}: status {status}, without {missing:?}:\n{said}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Refusals say what was read, and what to write.
#[test]
fn what_is_not_read_is_said_with_its_reason() {
    let said = |folder: &str, parts: &[&str]| {
        let (status, said) = judged(folder);
        assert_eq!(status, 2, "{said}");
        for part in parts {
            assert!(said.contains(part), "{folder} without {part:?}:\n{said}");
        }
    };
    said("31", &["the constraint `cx` fixes `x`", "the constraint `cx` is solved for `x`, so it has no multiplier"]);
    said("35", &["the program takes its state apart as `omega, theta`, in another order"]);
    let (status, said) = judged("30");
    assert_eq!(status, 0, "{said}");
}

/// Goal: no two statements of one proof exclude each other. Method: every model with a publication; two formulations
/// that equal a third one are equal. In `11`, a potential turns with a drive; in `17`, angles are quotients.
#[test]
fn proofs_of_equivalence_do_not_contradict_each_other() {
    let mut folders: Vec<&str> = CASES.iter().map(|case| case.folder).chain(["30", "31", "35"]).collect();
    folders.sort_unstable();
    for folder in folders {
        let model = format!("tests/data/verdicts/{folder}/model.toml");
        let (status, text, err) = tripos_in(&root(), &["prove", &model, "--json"]);
        let Ok(proof) = serde_json::from_str::<serde_json::Value>(&text) else { continue };
        let pairs = proof["pairs"].as_array().unwrap();
        let is_equal = |pair: &&serde_json::Value| pair["verdict"] == "equal";
        let of_kane = pairs.iter().filter(|pair| pair["left"] == "kane");
        assert!(of_kane.clone().all(|pair| is_equal(&pair)), "{folder}: {text} {err}");
        assert!(pairs.iter().all(|pair| is_equal(&pair)) && status == 0, "{folder}: {text} {err}");
    }
}
