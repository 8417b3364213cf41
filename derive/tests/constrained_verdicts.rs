//! Verdicts of `diff` on formulas that are right on the constraints of a model, or in its domain, and not elsewhere.
//!
//! Truth comes from outside Tripos's derivations: Newton's law and hand-written energies, evaluated at random states
//! that a solver of this file puts on the constraints. A formula that agrees there must be acquitted. Any other must be
//! convicted, by a state that is on the constraints.

use crate::differences::solved;
use std::collections::BTreeMap;
use tripos_derive::algebra::Arena;
use tripos_derive::algebra::meaning::compare::{Verdict, Witness};
use tripos_derive::algebra::meaning::permitted_states::PermittedStates;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Difference, Finding, judge_publication};
use tripos_derive::mechanics::{Derivations, derive_all};
use tripos_derive::model::load;
use tripos_derive::prove::prove;
use tripos_derive::publication;

pub struct Judged {
    derivations: Derivations,
    pub difference: Difference,
}

pub fn judge(model: &str, publication: &str) -> Judged {
    let mut model = load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    let source = Source::from_text("publication.toml", publication);
    let publication =
        publication::load_publication(&source, &mut model).unwrap_or_else(|e| panic!("{e}\n{publication}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let difference = judge_publication(&model, &mut derivations, &publication, &proof);
    Judged { derivations, difference }
}

impl Judged {
    fn finding(&self, id: &str) -> &Finding {
        self.difference.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("there is no {id}"))
    }

    /// The verdict, and the region where it holds.
    fn said(&self, id: &str) -> String {
        let finding = self.finding(id);
        let place = finding.holds.words().map_or_else(String::new, |words| format!(" {words}"));
        format!("{}{place}", finding.judgement.word())
    }
}

fn entry(id: &str, quantity: &str, printed: &str) -> String {
    format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n")
}

const SLEIGH: &str = r#"
name = "Sleigh"
[parameters]
m = { unit = "kg", value = 1, positive = true }
J = { unit = "kg*m^2", value = 0.5, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
phi = { unit = "rad" }
[speeds]
u = "x'*cos(phi) + y'*sin(phi)"
w = "phi'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "phi" }
[points]
P = { from = "O", frame = "N", position = ["x", "y", 0] }
[bodies.blade]
frame = "B"
centre = "P"
mass = "m"
inertia = { diagonal = [0, "J", "J"] }
[gravity]
frame = "N"
acceleration = ["g/2", 0, 0]
[constraints]
edge = { equation = "-x'*sin(phi) + y'*cos(phi) = 0" }
"#;

/// A point on a curve of the plane, with the curve and its speed to be filled in.
const BEAD: &str = r#"
name = "Bead"
[parameters]
m = { unit = "kg", value = 1, positive = true }
l = { unit = "m", value = 1, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
[speeds]
v = "(x*y' - y*x')/l"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", "y", 0] }
[particles]
bob = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
rod = { equation = "CURVE" }
"#;

const ATTITUDE: &str = r#"
name = "Attitude"
[parameters]
m = { unit = "kg", value = 1, positive = true }
Ix = { unit = "kg*m^2", value = 0.03, positive = true }
[inertial]
frame = "W"
origin = "O"
[bodies.uav]
frame = "B"
mass = "m"
inertia = { diagonal = ["Ix", "Ix", "Ix"] }
[joints.free]
kind = "ball"
body = "uav"
sequence = "euler"
coordinates = ["q1", "q2", "q3", "q4"]
speeds = ["wx", "wy", "wz"]
"#;

const LEG: &str = r#"
name = "Leg"
[parameters]
m = { unit = "kg", value = 1.3, positive = true }
k = { unit = "N/m", value = 300, positive = true }
r0 = { unit = "m", value = 1, positive = true }
g = { unit = "m/s^2", value = 9.8, positive = true }
[coordinates]
r = { unit = "m" }
theta = { unit = "rad" }
[speeds]
rdot = "r'"
thetadot = "theta'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "theta" }
[points]
P = { from = "O", frame = "B", position = [0, "r", 0] }
[particles]
body = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[domain]
long = "r > 0"
upright = "abs(theta) < pi/2"
[springs.leg]
on = "body"
at = "P"
against_at = "O"
stiffness = "k"
free_length = "r0"
"#;

#[test]
fn an_energy_in_dependent_rates_is_judged_on_the_constraint() {
    let judged = judge(
        SLEIGH,
        &[
            entry("own", "T", "m*x'^2/2 + m*y'^2/2 + J*phi'^2/2"),
            entry("along", "T", "m*(x'*cos(phi) + y'*sin(phi))^2/2 + J*phi'^2/2"),
            entry("turned", "T", "m*x'*(x' + y'*tan(phi))/2 + J*phi'^2/2"),
            entry("speeds", "T", "m*u^2/2 + J*w^2/2"),
            entry("half", "T", "m*x'^2/2 + m*y'^2/2 + J*phi'^2"),
            entry("sign", "T", "m*(x'*cos(phi) - y'*sin(phi))^2/2 + J*phi'^2/2"),
        ]
        .concat(),
    );
    assert_eq!(judged.said("own"), "equal");
    assert_eq!(judged.said("along"), "equal on the constraints");
    assert_eq!(judged.said("turned"), "equal on the constraints");
    assert_eq!(judged.said("speeds"), "equal");
    assert_eq!(judged.said("sign"), "different");
    let half = judged.finding("half");
    assert_eq!(half.judgement.word(), "different");
    assert_eq!(half.remarks, ["the term J*phi'^2 should be J*phi'^2/2"]);
    for id in ["half", "sign"] {
        let at = state(judged.finding(id).witness.as_ref().unwrap());
        let slip = at["x'"] * at["phi"].sin() - at["y'"] * at["phi"].cos();
        assert!(slip.abs() < 1e-12, "{id}: {at:?}");
    }
}

#[test]
fn an_energy_on_a_circle_is_judged_there() {
    let circle = BEAD.replace("CURVE", "x^2 + y^2 = l^2");
    let judged = judge(
        &circle,
        &[
            entry("T", "T", "m*(x'^2 + y'^2)/2"),
            entry("T-speed", "T", "m*v^2/2"),
            entry("T-wrong", "T", "m*v^2"),
            entry("V", "V", "m*g*y + m*g*(x^2 + y^2 - l^2)/l"),
        ]
        .concat(),
    );
    assert_eq!(judged.said("T"), "equal");
    assert_eq!(judged.said("T-speed"), "equal on the constraints");
    assert_eq!(judged.said("V"), "equal on the constraints");
    let wrong = judged.finding("T-wrong");
    let arena = &judged.derivations.kinematics.arena;
    assert_eq!(wrong.judgement.word(), "different");
    assert_eq!(print_text(arena, wrong.derived.unwrap()), "m*v^2/2");
    assert_eq!(print_text(arena, wrong.factor.unwrap()), "2");
}

#[test]
fn euler_parameters_have_length_one() {
    let judged = judge(
        ATTITUDE,
        &[
            entry("R11", "rotation(B, W) [1,1]", "2*(q1^2 + q2^2) - 1"),
            entry("R11b", "rotation(B, W) [1,1]", "1 - 2*(q3^2 + q4^2)"),
            entry("R12", "rotation(B, W) [1,2]", "2*(q2*q3 - q1*q4)"),
            entry("R23", "rotation(B, W) [2,3]", "2*(q1*q2 - q3*q4)"),
        ]
        .concat(),
    );
    for id in ["R11", "R11b", "R12"] {
        assert_eq!(judged.said(id), "equal on the constraints", "{id}");
    }
    let wrong = judged.finding("R23");
    assert_eq!(wrong.judgement.word(), "different");
    let arena = &judged.derivations.kinematics.arena;
    // 2 (q3 q4 − q1 q2), not divided by the squared length.
    assert!(!print_text(arena, wrong.derived.unwrap()).contains('/'));
    assert_eq!(print_text(arena, wrong.factor.unwrap()), "-1");
    let at = state(wrong.witness.as_ref().unwrap());
    let length: f64 = ["q1", "q2", "q3", "q4"].iter().map(|q| at[*q].powi(2)).sum();
    assert!((length - 1.0).abs() < 1e-12, "{at:?}");
}

#[test]
fn a_root_of_a_square_has_the_sign_that_the_domain_tells() {
    let judged = judge(
        LEG,
        &[
            entry("radial", "r''", "k/m*(r0 - r) + r*theta'^2 - g*cos(theta)"),
            entry("angular", "theta''", "(g*sin(theta) - 2*r'*theta')/r"),
            entry("size", "theta''", "(g*sin(theta) - 2*r'*theta')/sqrt(r^2)"),
            entry("upright", "theta''", "(g*sin(theta)*abs(cos(theta))/cos(theta) - 2*r'*theta')/abs(r)"),
            entry("wrong", "r''", "k/m*(r0 + r) + r*theta'^2 - g*cos(theta)"),
            entry("other-side", "r''", "k/m*(r0 + abs(r)) + r*theta'^2 - g*cos(theta)"),
        ]
        .concat(),
    );
    assert_eq!(judged.said("radial"), "equal in the domain");
    assert_eq!(judged.said("angular"), "equal");
    assert_eq!(judged.said("size"), "equal in the domain");
    assert_eq!(judged.said("upright"), "equal in the domain");
    for id in ["wrong", "other-side"] {
        assert_eq!(judged.said(id), "different", "{id}");
        assert!(state(judged.finding(id).witness.as_ref().unwrap())["r"] > 0.0);
    }
}

/// A system of Lagrange's equations with a multiplier.
fn with_multiplier(unknowns: [&str; 3], rows: &[[String; 4]; 3]) -> String {
    let list =
        |items: &[String]| format!("[{}]", items.iter().map(|e| format!("{e:?}")).collect::<Vec<_>>().join(", "));
    let matrix: Vec<String> = rows.iter().map(|row| list(&row[..3])).collect();
    let right: Vec<String> = rows.iter().map(|row| row[3].clone()).collect();
    format!(
        "[[system]]\nid = \"s\"\nsection = \"1\"\nformulation = \"lagrange\"\nunknowns = {unknowns:?}\nmatrix = [{}]\nright = {}\n",
        matrix.join(", "),
        list(&right)
    )
}

const UNKNOWNS: [&str; 3] = ["x''", "y''", "lambda_rod"];

fn on_circle(multiplier: [&str; 2], right: &str) -> Judged {
    let rows = [["m", "0", multiplier[0], "0"], ["0", "m", multiplier[1], "-m*g"], ["x", "y", "0", right]];
    let rows = rows.map(|row| row.map(str::to_owned));
    judge(&BEAD.replace("CURVE", "x^2 + y^2 = l^2"), &with_multiplier(UNKNOWNS, &rows))
}

#[test]
fn multipliers_may_have_factors_of_their_own() {
    let right = "-x'^2 - y'^2";
    for (multiplier, words) in [
        (["-2*x", "-2*y"], ["equal", "equal", "scaled"]),
        (["-x", "-y"], ["equal", "equal", "scaled"]),
        (["x/l", "y/l"], ["equal", "equal", "scaled"]),
        (["-x/sqrt(x^2 + y^2)", "-y/l"], ["equal", "equal on the constraints", "scaled"]),
    ] {
        let judged = on_circle(multiplier, right);
        let mut said: Vec<String> = judged.difference.findings.iter().map(|f| judged.said(&f.id)).collect();
        // Which of two rows tells the multiplier is open.
        said[..2].sort_unstable();
        assert_eq!(said, words, "{multiplier:?}");
        let system = &judged.difference.consequences[0];
        assert!(system.accelerations.is_equal(), "{multiplier:?}: {:?}", system.accelerations);
        assert!(!system.rates.is_empty() && system.rates.iter().all(|rate| rate.verdict.is_equal()), "{multiplier:?}");
        assert!(system.determinant.as_ref().unwrap().2.is_equal(), "{multiplier:?}");
    }
    for (multiplier, right) in [(["-x", "-2*y"], right), (["-x", "y"], right), (["-x", "-y"], "-x'^2 - 2*y'^2")] {
        let judged = on_circle(multiplier, right);
        assert!(judged.difference.count("different") > 0, "{multiplier:?}");
        assert!(matches!(judged.difference.consequences[0].accelerations, Verdict::Different(_)), "{multiplier:?}");
    }
}

/// Two cranks of a plane, tied by an equation between their angles.
const CRANKS: &str = r#"
name = "Cranks"
[parameters]
m = { unit = "kg", value = 1, positive = true }
a = { unit = "m", value = 1, positive = true }
b = { unit = "m", value = 2, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
[speeds]
u = "q2'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["a*cos(q1)", "a*sin(q1)", 0] }
[particles]
bob = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
tie = { equation = "TIE = 0" }
"#;

/// Truth by hand: with sin q1 = k sin q2, V = m g a sin q1 and T = m a² q1'²/2, where cos q1 q1' = k cos q2 q2'.
#[test]
fn loops_of_angles_are_solved_for_lengths_or_angles() {
    for (tie, k) in [
        ("a*sin(q1) - b*sin(q2)", "(b/a)"),
        ("sin(q1) - sin(q2)/2", "(1/2)"),
        ("a*(2*sin(q1) - sin(q2))", "(1/2)"),
        ("a*sin(q1) - 2*a*sin(q2)/3", "(2/3)"),
    ] {
        let judged = judge(
            &CRANKS.replace("TIE", tie),
            &[
                entry("V", "V", &format!("m*g*a*{k}*sin(q2)")),
                entry("T", "T", &format!("m*a^2*({k}*cos(q2)*q2'/cos(q1))^2/2")),
                entry("T-long", "T", &format!("m*a^2*({k}*cos(q2)*q2')^2/(2*(1 - {k}^2*sin(q2)^2))")),
                entry("T-wrong", "T", &format!("m*a^2*({k}*cos(q2)*q2')^2/(2*(1 + {k}^2*sin(q2)^2))")),
                entry("V-wrong", "V", &format!("m*g*a*{k}*sin(q1)")),
            ]
            .concat(),
        );
        for id in ["V", "T", "T-long"] {
            assert_eq!(judged.said(id), "equal on the constraints", "{tie}: {:?}", judged.finding(id));
        }
        for id in ["T-wrong", "V-wrong"] {
            let finding = judged.finding(id);
            assert_eq!(finding.judgement.word(), "different", "{tie}: {finding:?}");
            let at = state(finding.witness.as_ref().unwrap());
            if ["q1", "q2", "a", "b"].iter().all(|name| at.contains_key(*name)) {
                assert!(value(tie, &at).abs() < 1e-9, "{tie}: {at:?}");
            }
        }
    }
}

/// The values of a witness by their names.
fn state(witness: &Witness) -> BTreeMap<String, f64> {
    witness.at.iter().cloned().collect()
}

/// A small deterministic generator.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn number(&mut self) -> f64 {
        0.3 + (self.next() % 1000) as f64 / 600.0
    }

    fn signed(&mut self) -> f64 {
        if self.next().is_multiple_of(2) { self.number() } else { -self.number() }
    }

    fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[usize::try_from(self.next()).unwrap() % list.len()]
    }
}

/// The value of a formula where symbols have these values.
fn value(formula: &str, at: &BTreeMap<String, f64>) -> f64 {
    let mut arena = Arena::new();
    let e = parse_free(&mut arena, &formula.replace('\'', "_dot")).unwrap_or_else(|e| panic!("{formula}: {e:?}"));
    let names: Vec<String> = at.keys().map(|name| name.replace('\'', "_dot")).collect();
    let symbols: Vec<_> = names.iter().map(|name| arena.symbol(name)).collect();
    let values: Vec<f64> = at.values().copied().collect();
    Tape::new(&arena, &symbols, &[e]).unwrap().evaluate(&values)[0]
}

/// A state of a bead on a curve φ(x, y) = 0, by Newton's method along y, with a velocity along the curve.
fn on_curve(curve: &str, dice: &mut Dice) -> Option<BTreeMap<String, f64>> {
    let mut at: BTreeMap<String, f64> = ["m", "l", "g"].iter().map(|p| ((*p).to_owned(), dice.number())).collect();
    let (x, y) = (dice.signed() / 2.0, dice.signed());
    at.extend([("x".to_owned(), x), ("y".to_owned(), y)]);
    let slope = |at: &BTreeMap<String, f64>, along: &str| {
        let shifted = |h: f64| {
            let mut at = at.clone();
            *at.get_mut(along).unwrap() += h;
            value(curve, &at)
        };
        (shifted(1e-5) - shifted(-1e-5)) / 2e-5
    };
    for _ in 0..60 {
        let step = value(curve, &at) / slope(&at, "y");
        *at.get_mut("y").unwrap() -= step;
    }
    if value(curve, &at).abs() > 1e-12 || slope(&at, "y").abs() < 0.1 {
        return None;
    }
    let rate = dice.signed();
    let (along_x, along_y) = (-rate * slope(&at, "y"), rate * slope(&at, "x"));
    at.extend([("x'".to_owned(), along_x), ("y'".to_owned(), along_y)]);
    Some(at)
}

/// Goal: right formulas are acquitted however they are disguised on the constraint, wrong ones convicted. Method: T
/// and V of a bead on random curves, with multiples of φ and of its rate added, or with a coefficient changed; truth
/// by values at states on the curve.
#[test]
fn random_formulas_on_random_curves_are_judged_as_their_values_are() {
    let mut dice = Dice(7);
    let curves = [
        "x^2 + y^2 - l^2",
        "x^2/4 + y^2 - l^2",
        "x*y - l^2",
        "y - x^2/(2*l) - l/3",
        "x^2 + x*y + 2*y^2 - 3*l^2",
        "(x - l)^2 + (y + l/2)^2 - l^2",
        "x^3 + l^2*y - l^3",
    ];
    let (mut right, mut wrong) = (0, 0);
    for round in 0..28 {
        let curve = curves[round % curves.len()];
        let mut arena = Arena::new();
        let (x, y) = (arena.symbol("x"), arena.symbol("y"));
        let phi = parse_free(&mut arena, curve).unwrap();
        let [fx, fy] = [x, y].map(|s| {
            let slope = tripos_derive::algebra::term::calculus::Differential::partial(s).apply(&mut arena, phi);
            print_text(&arena, slope)
        });
        let rate = format!("(({fx})*x' + ({fy})*y')");
        let k = dice.pick(&["1", "2", "1/3", "m", "x/l", "y^2", "cos(x)"]);
        let (quantity, plain, change) = match round % 3 {
            0 => ("T", "m*x'^2/2 + m*y'^2/2".to_owned(), "m*x'^2/2 + m*y'^2/3"),
            1 => ("V", "m*g*y".to_owned(), "m*g*y*(1 + x/(5*l))"),
            _ => ("energy", "m*(x'^2 + y'^2)/2 + m*g*y".to_owned(), "m*(x'^2 + y'^2)/2 + 2*m*g*y"),
        };
        let plain = if dice.next().is_multiple_of(2) { plain } else { change.to_owned() };
        let disguise = if quantity == "V" || dice.next().is_multiple_of(2) {
            format!("({k})*({curve})")
        } else {
            format!("({k})*{rate}")
        };
        let printed = format!("{plain} + {disguise}*{}", dice.pick(&["1", "m/2", "sin(y)"]));
        // Its speed along x is regular where the curve is not vertical.
        let model = BEAD.replace("CURVE", &format!("{curve} = 0")).replace("(x*y' - y*x')/l", "x'");
        let judged = judge(&model, &entry("e", quantity, &printed));
        let truth = |at: &BTreeMap<String, f64>| {
            let (t, v) = (at["m"] * (at["x'"].powi(2) + at["y'"].powi(2)) / 2.0, at["m"] * at["g"] * at["y"]);
            match quantity {
                "T" => t,
                "V" => v,
                _ => t + v,
            }
        };
        let states: Vec<_> = (0..60).filter_map(|_| on_curve(curve, &mut dice)).take(8).collect();
        assert!(states.len() >= 4, "{curve}");
        let is_right = states.iter().all(|at| (value(&printed, at) - truth(at)).abs() < 1e-7 * (1.0 + truth(at).abs()));
        let finding = judged.finding("e");
        let word = finding.judgement.word();
        assert_eq!(word, if is_right { "equal" } else { "different" }, "{curve}: {quantity} = {printed}: {finding:?}");
        *(if is_right { &mut right } else { &mut wrong }) += 1;
        if !is_right {
            let at = state(finding.witness.as_ref().unwrap());
            if ["x", "y", "l"].iter().all(|name| at.contains_key(*name)) {
                assert!(value(curve, &at).abs() < 1e-9, "{curve}: {at:?}");
            }
        }
    }
    assert!(right >= 8 && wrong >= 8, "{right} right, {wrong} wrong");
}

/// Goal: systems with a multiplier are judged by the motion that they give. Method: random disguises of a sleigh's
/// equations, and random mistakes. Truth: the printed numbers, solved at states on the constraint, against Newton's
/// law with the blade's force.
#[test]
fn random_systems_with_multipliers_are_judged_as_their_accelerations_are() {
    let mut dice = Dice(11);
    let (mut right, mut wrong) = (0, 0);
    for round in 0..24 {
        let edge = ["-sin(phi)", "cos(phi)", "0"];
        let slope = "(x'*cos(phi) + y'*sin(phi))*phi'";
        let slip = "(y'*cos(phi) - x'*sin(phi))";
        let k = dice.pick(&["1", "-1", "2", "-m", "1/3", "(2 + cos(phi))"]);
        let mut rows: Vec<Vec<String>> = vec![
            vec!["m".into(), "0".into(), "0".into(), format!("-({k})*({})", edge[0]), "m*g/2".into()],
            vec!["0".into(), "m".into(), "0".into(), format!("-({k})*({})", edge[1]), "0".into()],
            vec!["0".into(), "0".into(), "J".into(), "0".into(), "0".into()],
            vec![edge[0].into(), edge[1].into(), edge[2].into(), "0".into(), slope.into()],
        ];
        let at = usize::try_from(dice.next()).unwrap() % 4;
        match dice.next() % 4 {
            // What is zero on the constraint.
            0 => rows[at][4] = format!("{} + {slip}*x'*m", rows[at][4]),
            1 => rows[at] = rows[at].iter().map(|e| format!("3*({e})/2")).collect(),
            2 => rows[at % 3][0] = format!("{} + m*{slip}*phi'", rows[at % 3][0]),
            _ => {}
        }
        if round % 2 == 1 {
            // A slip: one entry that is not zero has another factor.
            let entries: Vec<usize> = (0..5).filter(|c| rows[at][*c] != "0").collect();
            let column = dice.pick(&entries);
            rows[at][column] = format!("2*({})", rows[at][column]);
        }
        let list =
            |items: &[String]| format!("[{}]", items.iter().map(|e| format!("{e:?}")).collect::<Vec<_>>().join(", "));
        let matrix: Vec<String> = rows.iter().map(|row| list(&row[..4])).collect();
        let column: Vec<String> = rows.iter().map(|row| row[4].clone()).collect();
        let publication = format!(
            "[[system]]\nid = \"s\"\nsection = \"1\"\nformulation = \"lagrange\"\nunknowns = [\"x''\", \"y''\", \"phi''\", \"lambda_edge\"]\nmatrix = [{}]\nright = {}\n",
            matrix.join(", "),
            list(&column)
        );
        let judged = judge(SLEIGH, &publication);
        let same = (0..6).all(|_| {
            let mut at: BTreeMap<String, f64> =
                ["m", "J", "g"].iter().map(|p| ((*p).to_owned(), dice.number())).collect();
            let (phi, u, w) = (dice.signed(), dice.signed(), dice.signed());
            let more =
                [("x", 0.4), ("y", 0.9), ("phi", phi), ("x'", u * phi.cos()), ("y'", u * phi.sin()), ("phi'", w)];
            at.extend(more.map(|(name, x)| (name.to_owned(), x)));
            let a: Vec<f64> =
                rows.iter().flat_map(|row| row[..4].iter().map(|e| value(e, &at)).collect::<Vec<_>>()).collect();
            let b: Vec<f64> = rows.iter().map(|row| value(&row[4], &at)).collect();
            let found = solved(4, &a, &b);
            // Along the blade gravity alone: u' = (g/2) cos φ; across it the blade turns the velocity.
            let rate = at["g"] / 2.0 * phi.cos();
            let truth = [rate * phi.cos() - u * w * phi.sin(), rate * phi.sin() + u * w * phi.cos(), 0.0];
            found.iter().zip(truth).all(|(a, b)| (a - b).abs() < 1e-9 * (1.0 + b.abs()))
        });
        let system = &judged.difference.consequences[0];
        let shown: Vec<String> =
            judged.difference.findings.iter().map(|f| format!("{}: {}", f.id, judged.said(&f.id))).collect();
        if same {
            right += 1;
            assert!(system.accelerations.is_equal(), "{publication}: {:?}", system.accelerations);
            assert_eq!(
                judged.difference.count("different") + judged.difference.count("undecided"),
                0,
                "{publication}: {shown:?}"
            );
        } else {
            wrong += 1;
            assert!(matches!(system.accelerations, Verdict::Different(_)), "{publication}: {:?}", system.accelerations);
            assert!(judged.difference.count("different") > 0, "{publication}: {shown:?}");
        }
    }
    assert!(right >= 8 && wrong >= 8, "{right} right, {wrong} wrong");
}

/// Goal: an equality that needs the constraints and the domain together is found, and told to need both. Method: √(b²)
/// is a where b = a and a > 0; neither fact alone is enough.
#[test]
fn an_equality_may_need_the_constraints_and_the_domain() {
    let mut arena = Arena::new();
    let [a, b] = ["a", "b"].map(|name| arena.symbol(name));
    let root = parse_free(&mut arena, "sqrt(b^2)").unwrap();
    let mut permitted = PermittedStates::new(&mut arena, vec![(b, a)], vec![a]);
    let views = permitted.rewritten_sides(&mut arena, root, a).unwrap();
    let equal: Vec<(bool, bool)> = views
        .iter()
        .filter(|view| view.sides.0 == view.sides.1)
        .map(|view| (view.holds.on_constraints, view.holds.in_domain))
        .collect();
    assert_eq!(equal, [(true, true)]);
}
