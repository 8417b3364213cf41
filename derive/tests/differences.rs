//! Verdicts of `diff` on printed equations.

use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Difference, Finding, Judgement, judge_publication, printed_equations};
use tripos_derive::mechanics::{Derivations, derive_all};
use tripos_derive::prove::{Proof, prove};
use tripos_derive::{Model, model, publication};

struct Judged {
    model: Model,
    derivations: Derivations,
    proof: Proof,
    publication: publication::Publication,
    difference: Difference,
}

fn judge(mut model: Model, source: &Source) -> Judged {
    let publication = publication::load_publication(source, &mut model).unwrap_or_else(|errors| panic!("{errors}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let difference = judge_publication(&model, &mut derivations, &publication, &proof);
    Judged { model, derivations, proof, publication, difference }
}

fn course_report() -> Judged {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/disk");
    let model = Model::read(&folder.join("model.toml")).unwrap();
    judge(model, &Source::read(&folder.join("publication.toml")).unwrap())
}

impl Judged {
    fn finding(&self, id: &str) -> &Finding {
        self.difference.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("there is no {id}"))
    }

    fn difference_of(&self, id: &str) -> String {
        let difference = self.finding(id).difference.unwrap_or_else(|| panic!("{id} has no difference"));
        print_text(&self.derivations.kinematics.arena, difference)
    }
}

/// A pendulum: m l² u' = −m g l sin q.
const PENDULUM: &str = r#"
name = "Pendulum"
[parameters]
m = { unit = "kg", positive = true }
l = { unit = "m", positive = true }
g = { unit = "m/s^2", positive = true }
[coordinates]
q = { unit = "rad" }
[speeds]
u = "q'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q" }
[points]
P = { from = "O", frame = "A", position = [0, "-l", 0] }
[particles]
bob = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

fn pendulum(publication: &str) -> Judged {
    let model = model::load(&Source::from_text("pendulum.toml", PENDULUM)).unwrap();
    judge(model, &Source::from_text("publication.toml", publication))
}

#[test]
fn every_entry_of_the_course_report_is_judged() {
    let judged = course_report();
    let difference = &judged.difference;
    assert_eq!(difference.count("undecided"), 0);
    let ids: Vec<String> = judged.publication.entries.iter().flat_map(publication::Entry::ids).collect();
    // Zeros that no line of a program states are left out where they are right.
    let missing: Vec<&String> = ids.iter().filter(|id| !difference.findings.iter().any(|f| f.id == **id)).collect();
    assert!(missing.iter().all(|id| id.starts_with("listing-5") && id.contains("-E")), "{missing:?}");
    for f in &difference.findings {
        let argued = f.difference.is_some() || !f.remarks.is_empty();
        assert!(f.judgement != Judgement::Different || (argued && f.witness.is_some()), "{} is not argued", f.id);
    }
}

/// Truth by hand: T*₁ = −M R²/4 (u1' + 2 u2 u3 − u2² t2), where the publication prints 3 u2 u3 in (3.2) and 2 u2 u3 in
/// (3.3).
#[test]
fn the_errors_of_the_course_report_are_found_by_their_terms() {
    let judged = course_report();
    for (id, difference) in [
        ("kane-3.2-line3-b1", "-M*R^2*u2*u3/4"),
        ("kane-final-row1", "R*u2*(u3 - 2*u2*tan(q2))"),
        ("kane-final-row2", "R*u1*(u2*tan(q2) - u3)"),
        ("lagrange-3.9-A5", "R*q1'^2*cos(q1)*(sin(q2) - cos(q2))"),
        ("newton-euler-final-row5", "u1*(u2*tan(q2) - u3)"),
        ("listing-5.4-dz10", "R*u2*cos(q1)*tan(q2)*(u2 - 2)/cos(q2)"),
    ] {
        assert_eq!(judged.finding(id).judgement, Judgement::Different, "{id}");
        assert_eq!(judged.difference_of(id), difference, "{id}");
    }
    for id in ["2.11-a1", "2.7-b1", "kane-3.3-F1-line2", "kane-3.3-F2-line2", "lagrange-3.3", "lagrange-3.4", "2.9-v1"]
    {
        assert_eq!(judged.finding(id).judgement, Judgement::Equal, "{id}");
    }
    for id in ["kane-final-row3", "kane-final-row4", "kane-final-row5", "newton-euler-final-row1", "lagrange-3.8-E13"] {
        assert!(matches!(judged.finding(id).judgement, Judgement::Scaled | Judgement::Equal), "{id}");
    }
    assert_eq!(judged.finding("2.8").judgement, Judgement::Stated);
    for id in ["4.4-u1", "4.4-u2", "4.4-u3", "4.3-q1'", "listing-5.7-qd10"] {
        assert_eq!(judged.finding(id).judgement, Judgement::Different, "{id}");
    }
}

/// Goal: rates of integrals along printed equations. Method: central differences of the integral along the printed
/// accelerations, solved in floating point, at one state; h² of the difference is 1e-10.
#[test]
fn rates_of_integrals_are_those_of_the_printed_motion() {
    let mut judged = course_report();
    let state = [1.3, 0.7, 9.81, 0.4, 0.6, -0.3, 1.1, -0.8, 0.5, -1.2, 0.9, 0.3, -0.7];
    let printed = printed_equations(&judged.model, &mut judged.derivations, &judged.publication);
    let arena = &judged.derivations.kinematics.arena;
    let inputs = [judged.model.p(), judged.model.q(), judged.model.u()].concat();
    let mut compared = 0;
    for e in printed.iter().filter(|e| e.variables == judged.model.u()) {
        let n = e.unknowns.len();
        let outputs = [e.matrix.concat(), e.forcing.clone(), e.coordinate_rates.clone()].concat();
        let values = Tape::new(arena, &inputs, &outputs).unwrap().evaluate(&state);
        let x = solved(n, &values[..n * n], &values[n * n..n * n + n]);
        let rates = [&values[n * n + n..], &x[..5]].concat();
        let id = e.by.printed_id().unwrap();
        let consequences = judged.difference.consequences.iter().find(|c| c.system == id).unwrap();
        for (rate, integral) in consequences.rates.iter().zip(&judged.proof.integrals) {
            let along = |h: f64| {
                let mut moved = state;
                moved[3..].iter_mut().zip(&rates).for_each(|(y, r)| *y += h * r);
                Tape::new(arena, &inputs, &[integral.expression]).unwrap().evaluate(&moved)[0]
            };
            let h = 1e-5;
            let measured = (along(h) - along(-h)) / (2.0 * h);
            let stated = Tape::new(arena, &inputs, &[rate.rate]).unwrap().evaluate(&state)[0];
            assert!(
                (measured - stated).abs() < 1e-6 * (1.0 + stated.abs()),
                "{id}: {:?}: {measured} {stated}",
                rate.integral.kinds
            );
            assert_eq!(rate.verdict.is_equal(), measured.abs() < 1e-6, "{id}: {:?}", rate.integral.kinds);
            compared += 1;
        }
    }
    assert_eq!(compared, 4 * 6);
}

/// Gaussian elimination with row exchange.
pub fn solved(n: usize, a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut rows: Vec<Vec<f64>> = (0..n).map(|i| [&a[i * n..i * n + n], &[b[i]]].concat()).collect();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs())).unwrap();
        rows.swap(k, pivot);
        for i in (0..n).filter(|i| *i != k) {
            let factor = rows[i][k] / rows[k][k];
            let from = rows[k].clone();
            rows[i].iter_mut().zip(&from).for_each(|(x, y)| *x -= factor * y);
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

#[test]
fn energy_alone_does_not_certify_equations() {
    let judged = course_report();
    let of = |id: &str| judged.difference.consequences.iter().find(|c| c.system == id).unwrap();
    let newton_euler = of("newton-euler-final");
    assert!(matches!(newton_euler.accelerations, Verdict::Different(_)));
    let kept: Vec<bool> = newton_euler.rates.iter().map(|r| r.verdict.is_equal()).collect();
    assert_eq!(kept, [true, true, true, true, false, false], "energy and momenta hold, angular momentum does not");
    let pair = |a: &str, b: &str| {
        let found = judged.difference.agreements.iter().find(|x| x.left == a && x.right == b);
        found.unwrap().verdict.is_equal()
    };
    assert!(pair("newton-euler-final", "listing-5.6"), "the program solves the printed system");
    assert!(!pair("kane-final", "newton-euler-final"));
    // The printed matrix of Kane's method is the derived one, and regular in every state.
    let (printed, _, verdict) = of("kane-final").determinant.as_ref().unwrap();
    assert!(verdict.is_equal());
    assert_eq!(print_text(&judged.derivations.kinematics.arena, *printed), "R^2*(4*cos(q2)^2 - 5)");
}

#[test]
fn rows_may_carry_factors_be_exchanged_and_be_combined() {
    let system = |matrix: &str, right: &str| {
        format!(
            "[[system]]\nid = \"s\"\nsection = \"1\"\nformulation = \"kane\"\nunknowns = [\"u1'\", \"u2'\"]\n\
             matrix = {matrix}\nright = {right}\n"
        )
    };
    let two = PENDULUM
        .replace("q = { unit = \"rad\" }", "q = { unit = \"rad\" }\nx = { unit = \"m\" }")
        .replace("u = \"q'\"", "u1 = \"q'\"\nu2 = \"x'\"")
        .replace("from = \"O\", frame = \"A\"", "from = \"B\", frame = \"A\"")
        .replace("[points]", "[points]\nB = { from = \"O\", frame = \"N\", position = [\"x\", 0, 0] }");
    let words = |matrix: &str, right: &str| {
        let model = model::load(&Source::from_text("two.toml", &two)).unwrap_or_else(|e| panic!("{e}"));
        let judged = judge(model, &Source::from_text("publication.toml", &system(matrix, right)));
        judged.difference.findings.iter().map(|f| f.judgement.word()).collect::<Vec<_>>()
    };
    // m l² u1' + m l cos q u2' = −m g l sin q;  m l cos q u1' + m u2' = m l u1² sin q.
    let (a, b) = (r#"["m*l^2", "m*l*cos(q)"]"#, r#"["m*l*cos(q)", "m"]"#);
    let (f, h) = ("\"-m*g*l*sin(q)\"", "\"m*l*u1^2*sin(q)\"");
    assert_eq!(words(&format!("[{a}, {b}]"), &format!("[{f}, {h}]")), ["equal", "equal"]);
    assert_eq!(words(&format!("[{b}, {a}]"), &format!("[{h}, {f}]")), ["equal", "equal"]);
    let scaled = words(r#"[["l", "cos(q)"], ["cos(q)^2", "cos(q)/l"]]"#, r#"["-g*sin(q)", "u1^2*sin(q)*cos(q)"]"#);
    assert_eq!(scaled, ["scaled", "scaled"]);
    // The sum of both rows, and u2' eliminated from the first.
    let combined = words(
        r#"[["m*l^2 + m*l*cos(q)", "m*l*cos(q) + m"], ["l*sin(q)^2", 0]]"#,
        r#"["m*l*u1^2*sin(q) - m*g*l*sin(q)", "-g*sin(q) - l*u1^2*sin(q)*cos(q)"]"#,
    );
    assert_eq!(combined, ["scaled", "scaled"]);
    let wrong = words(
        r#"[["m*l^2 + m*l*cos(q)", "m*l*cos(q) + m"], ["l*sin(q)^2", 0]]"#,
        r#"["m*l*u1^2*sin(q) + m*g*l*sin(q)", "-g*sin(q) + l*u1^2*sin(q)*cos(q)"]"#,
    );
    assert_eq!(wrong, ["different", "different"]);
}

#[test]
fn a_value_off_by_a_factor_is_different_and_the_factor_is_named() {
    let judged = pendulum(
        "[[equation]]\nid = \"V\"\nsection = \"1\"\nquantity = \"V\"\nprinted = \"m*g*l*cos(q)\"\n\
         [[equation]]\nid = \"T\"\nsection = \"1\"\nquantity = \"T\"\nprinted = \"m*l^2*q'^2/2\"\n",
    );
    assert_eq!(judged.finding("T").judgement, Judgement::Equal, "q' and u are one");
    let v = judged.finding("V");
    assert_eq!(v.judgement, Judgement::Different);
    assert_eq!(print_text(&judged.derivations.kinematics.arena, v.factor.unwrap()), "-1");
}

/// Errors are counted where they are made: a named symbol is what is derived, not what another line prints for it.
#[test]
fn a_wrong_line_does_not_make_its_users_wrong() {
    let judged = pendulum(
        "[names]\nv1 = \"v(P) @ A [1]\"\n\
         [[equation]]\nid = \"a\"\nsection = \"1\"\nquantity = \"v(P) @ A [1]\"\nprinted = \"-l*u\"\n\
         [[equation]]\nid = \"b\"\nsection = \"1\"\nquantity = \"T\"\nprinted = \"m*v1^2/2\"\n",
    );
    assert_eq!(judged.finding("a").judgement, Judgement::Different);
    assert_eq!(judged.finding("b").judgement, Judgement::Equal);
}

#[test]
fn printed_numbers_are_judged_by_definitions_and_by_one_another() {
    let number = |id: &str, set: &str, quantity: &str, printed: &str| {
        format!(
            "[[initial]]\nid = \"{id}\"\nsection = \"1\"\nset = \"{set}\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n"
        )
    };
    let text = number("a", "text", "q", "0.1745")
        + &number("b", "text", "q'", "0.2")
        + &number("c", "text", "u", "0.25")
        + &number("d", "program", "q", "10*pi/180")
        + &number("e", "program", "q'", "0.2005");
    let judged = pendulum(&text);
    let words: Vec<&str> = judged.difference.findings.iter().map(|f| f.judgement.word()).collect();
    // 0.1745 is 10° rounded; u = q' is contradicted; 0.2 and 0.2005 differ by more than four decimals allow.
    assert_eq!(words, ["equal", "different", "different", "equal", "different"]);
}

/// Goal: a verdict names the wrong term. Method: one term of each entry changed by hand: a coefficient, a sign, a
/// term too many, a term too few; and a row of the course report, whose right-hand side prints 3 u1 u3 for 2 u1 u3.
#[test]
fn a_verdict_names_the_term_that_is_wrong() {
    let entry = |id: &str, quantity: &str, printed: &str| {
        format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n")
    };
    // T = m l² u²/2 and V = −m g l cos q; the energy is their sum.
    let judged = pendulum(
        &[
            entry("coefficient", "energy", "m*l^2*u^2/4 - m*g*l*cos(q)"),
            entry("sign", "energy", "m*(l^2*u^2/2 + g*l*cos(q))"),
            entry("more", "energy", "m*l^2*u^2/2 - m*g*l*cos(q) + m*g*l*sin(q)"),
            entry("other", "energy", "m*l^2*u^2/2 + m*g*l*q"),
            entry("both", "energy", "m*l^2*u^2 - 3*m*g*l*cos(q) "),
            entry("right", "energy", "m*l^2*u^2/2 - m*g*l*cos(q)"),
        ]
        .concat(),
    );
    let said = |id: &str| judged.finding(id).remarks.join("; ");
    assert_eq!(said("coefficient"), "the term m*l^2*u^2/4 should be m*l^2*u^2/2");
    assert_eq!(said("sign"), "the term m*l*g*cos(q) should be -m*l*g*cos(q)");
    assert_eq!(said("more"), "the term m*l*g*sin(q) should not be there");
    assert_eq!(
        said("both"),
        "the term m*l^2*u^2 should be m*l^2*u^2/2; the term -3*m*l*g*cos(q) should be -m*l*g*cos(q)"
    );
    assert_eq!(said("other"), "the term m*l*g*q should be -m*l*g*cos(q)");
    assert_eq!(said("right"), "");
    let course = course_report();
    let row = course.finding("newton-euler-final-row5").remarks.join("; ");
    assert!(row.contains("the term 3*u1*u3 should be 2*u1*u3"), "{row}");
}
