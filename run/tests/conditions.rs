//! Conditions for rest and for steady motion in closed form.
//!
//! Truth: formulas of textbooks (Gantmacher, Lectures in Analytical Mechanics, 1970, ch. 5; Landau & Lifshitz,
//! Mechanics, § 14 and 35; Kane & Levinson, Dynamics, 1985), typed in here as they stand there, and Newton's method in
//! 32 digits.

use std::path::Path;
use tripos::Mechanism;
use tripos::studies::steady::{BranchesAt, Conditions, FoundMotion, SteadyConditions, conditions, find_equilibria};
use tripos_derive::algebra::Arena;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{StateWithUnknowns, load_state_with_unknowns};

fn read(model: &str) -> Mechanism {
    if model.contains('\n') {
        let source = Source::from_text("model.toml", model);
        return Mechanism::new(tripos_derive::model::load(&source).unwrap_or_else(|e| panic!("{e}")));
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    Mechanism::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn closed(model: &str, wanted: &[&str]) -> SteadyConditions {
    let wanted: Vec<String> = wanted.iter().map(|name| (*name).to_owned()).collect();
    conditions(&read(model), &wanted).unwrap_or_else(|e| panic!("{e}"))
}

/// Text of the equations and branches, one a line.
fn in_lines(conditions: &Conditions) -> String {
    let mut lines: Vec<String> = conditions.equations.iter().map(|e| format!("0 = {}", e.text)).collect();
    for branch in &conditions.branches {
        let solved = branch.solved.iter().map(|told| format!("{} = {}", told.name.text, told.value.text));
        let needs = branch.needs.iter().map(|need| need.text.clone());
        let divided = branch.divided_by.iter().map(|e| format!("{} != 0", e.text));
        let left = branch.left.iter().map(|e| format!("left {}", e.text));
        lines.push(solved.chain(needs).chain(divided).chain(left).collect::<Vec<_>>().join(", "));
    }
    lines.join("\n")
}

/// Value of a formula at these numbers, read from its text; rates have no primes.
fn value(formula: &str, given: &[(String, f64)]) -> f64 {
    let mut arena = Arena::new();
    let plain = |text: &str| text.replace('\'', "_dot");
    let symbols: Vec<_> = given.iter().map(|(name, _)| arena.symbol(&plain(name))).collect();
    let e = parse_free(&mut arena, &plain(formula)).unwrap_or_else(|e| panic!("{formula}: {e:?}"));
    let numbers: Vec<f64> = given.iter().map(|(_, x)| *x).collect();
    Tape::new(&arena, &symbols, &[e]).unwrap().evaluate(&numbers)[0]
}

/// Numbers between 0.4 and 1.6 that differ for each place and turn.
fn number(place: usize, turn: usize) -> f64 {
    0.4 + 1.2 * ((place as f64 + 1.0) * 0.754_877_666 + (turn as f64 + 1.0) * 0.569_840_29).fract()
}

fn numbers(names: &[&str], turn: usize) -> Vec<(String, f64)> {
    names.iter().enumerate().map(|(place, name)| ((*name).to_owned(), number(place, turn))).collect()
}

const HOOP: &str = r#"
name = "Bead on a hoop that turns freely"
[parameters]
m = { unit = "kg", value = 1, positive = true }
r = { unit = "m", value = 1, positive = true }
J = { unit = "kg*m^2", value = 2, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
[coordinates]
psi = { unit = "rad" }
q = { unit = "rad" }
[speeds]
w = "psi'"
u = "q'"
[inertial]
frame = "N"
origin = "O"
[frames]
H = { from = "N", axis = 3, angle = "psi" }
B = { from = "H", axis = 2, angle = "-q" }
[points]
P = { from = "O", frame = "B", position = [0, 0, "-r"] }
[particles]
bead = { point = "P", mass = "m" }
[bodies.hoop]
frame = "H"
centre = "O"
mass = "m"
inertia = { diagonal = ["J", "J", "J"] }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#;

const DOUBLE: &str = r#"
name = "Double pendulum, with the angle between its rods"
[parameters]
m = { unit = "kg", value = 1, positive = true }
M = { unit = "kg", value = 2, positive = true }
l = { unit = "m", value = 1, positive = true }
h = { unit = "m", value = 0.7, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
k = { unit = "N*m", value = 0 }
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
[speeds]
u1 = "q1'"
u2 = "q2'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q1" }
B = { from = "A", axis = 3, angle = "q2" }
[points]
P = { from = "O", frame = "A", position = [0, "-l", 0] }
Q = { from = "P", frame = "B", position = [0, "-h", 0] }
[particles]
upper = { point = "P", mass = "M" }
lower = { point = "Q", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// Goal: formulas read as in a textbook. Method: snapshots of rest and steady motion of mechanisms with known formulas.
/// They are a bead on a hoop, cos q = g/(r ω²); a conical pendulum, ω² = g/(l cos θ); and a double pendulum, which has
/// four poses of rest.
#[test]
fn closed_forms_are_those_of_the_textbook() {
    let expected = |model: &str, wanted: &[&str], at: usize, expected: expect_test::Expect| {
        expected.assert_eq(&in_lines(&closed(model, wanted).list[at]));
    };
    expected(
        "pendulum",
        &[],
        0,
        expect_test::expect![[r"
        0 = m*l*g*sin(theta)
        theta = 0
        theta = pi"]],
    );
    expected(
        HOOP,
        &[],
        1,
        expect_test::expect![[r"
        0 = m*r*sin(q)*(r*psi'^2*cos(q) - g)
        q = 0
        q = pi
        psi'^2 = g/(r*cos(q)), cos(q) >= 0, cos(q) != 0"]],
    );
    expected(
        HOOP,
        &["q"],
        1,
        expect_test::expect![[r"
        0 = m*r*sin(q)*(r*psi'^2*cos(q) - g)
        q = 0
        q = pi
        cos(q) = g/(r*psi'^2), abs(g/(r*psi'^2)) <= 1, psi' != 0"]],
    );
    expected(
        "spherical_pendulum",
        &[],
        1,
        expect_test::expect![[r"
        0 = m*l*sin(theta)*(l*phi'^2*cos(theta) - g)
        phi'^2 = g/(l*cos(theta)), cos(theta) >= 0, cos(theta) != 0"]],
    );
    expected(
        DOUBLE,
        &[],
        0,
        expect_test::expect![[r"
        0 = l*g*sin(q1)*(m + M)
        0 = m*h*g*(cos(q1)*sin(q2) + sin(q1)*cos(q2))
        q1 = 0, q2 = 0
        q1 = 0, q2 = pi
        q1 = pi, q2 = 0
        q1 = pi, q2 = pi"]],
    );
    expected(
        "cart_with_spring",
        &[],
        0,
        expect_test::expect![[r"
        0 = k*(l*sqrt(x^2) - x^2)
        x^2 = l^2"]],
    );
    expected(
        "elastic_pendulum",
        &[],
        0,
        expect_test::expect![[r"
        0 = k*x*(l*sqrt(x^2 + y^2) - x^2 - y^2)
        0 = -m*g*x^2 - y*(m*g*y + k*(x^2 + y^2 - l*sqrt(x^2 + y^2)))
        x = 0, y = -(k*l + m*g)/k
        x = 0, y = (k*l - m*g)/k, k*l - m*g >= 0"]],
    );
    expected(
        "rolling_disc",
        &[],
        1,
        expect_test::expect![[r"
        0 = r*m*(4*g*sin(q2) + r*q1'*cos(q2)*(5*q1'*sin(q2) + 6*q3'))/4
        0 = y*q1' + r*q3'*cos(q1) - V_x
        0 = r*q3'*sin(q1) - x*q1' - V_y
        V_x = -(4*g*cos(q1)*sin(q2) + q1'^2*cos(q2)*(5*r*cos(q1)*sin(q2) - 6*y))/(6*q1'*cos(q2)), V_y = -(4*g*sin(q1)*sin(q2) + q1'^2*cos(q2)*(5*r*sin(q1)*sin(q2) + 6*x))/(6*q1'*cos(q2)), q3' = -tan(q2)*(4*g + 5*r*q1'^2*cos(q2))/(6*r*q1'), cos(q2) != 0, q1' != 0
        V_x = r*q3'*cos(q1), V_y = r*q3'*sin(q1), q1' = 0, q2 = 0
        V_x = r*q3'*cos(q1), V_y = r*q3'*sin(q1), q1' = 0, q2 = pi"]],
    );
    expected(
        "heavy_top",
        &["Omega_n3"],
        1,
        expect_test::expect![[r"
        0 = sin(q1)*(m*l*g - Omega_n3*(I3*(Omega_q3 + Omega_n3*cos(q1)*cos(q2)) - I1*Omega_n3*cos(q1)*cos(q2)))
        0 = cos(q1)*sin(q2)*(m*l*g - Omega_n3*(I3*(Omega_q3 + Omega_n3*cos(q1)*cos(q2)) - I1*Omega_n3*cos(q1)*cos(q2)))
        Omega_n3 = (I3*Omega_q3 + sqrt(4*m*l*g*cos(q1)*cos(q2)*(I3 - I1) + I3^2*Omega_q3^2))/(2*cos(q1)*cos(q2)*(I1 - I3)), 4*m*l*g*cos(q1)*cos(q2)*(I3 - I1) + I3^2*Omega_q3^2 >= 0, I1 - I3 != 0, cos(q1) != 0, cos(q2) != 0
        Omega_n3 = (I3*Omega_q3 - sqrt(4*m*l*g*cos(q1)*cos(q2)*(I3 - I1) + I3^2*Omega_q3^2))/(2*cos(q1)*cos(q2)*(I1 - I3)), 4*m*l*g*cos(q1)*cos(q2)*(I3 - I1) + I3^2*Omega_q3^2 >= 0, I1 - I3 != 0, cos(q1) != 0, cos(q2) != 0
        q1 = pi/2, Omega_n3 = m*l*g/(I3*Omega_q3), Omega_q3 != 0
        q1 = -pi/2, Omega_n3 = m*l*g/(I3*Omega_q3), Omega_q3 != 0
        q1 = 0, q2 = 0
        q1 = 0, q2 = pi
        q1 = pi, q2 = 0
        q1 = pi, q2 = pi"]],
    );
}

/// Goal: formulas are right for all numbers. Method: they are read from their text and put into the equations of
/// textbooks at random numbers. These are: A Ω² cos θ − C n Ω + m g l = 0 of the top with the spin n about its axis;
/// the governor with rods of mass; the moments about the mass centre of a thin disc that rolls (6/4 and 5/4 m r²) or
/// slides (2/4 and 1/4).
#[test]
fn formulas_meet_the_equations_of_the_textbook() {
    for turn in 0..20 {
        let all = numbers(&["m", "l", "I1", "I3", "g", "Omega_q3", "q1", "q2"], turn);
        let [m, l, a, c, g, spin, q1, q2] = [0, 1, 2, 3, 4, 5, 6, 7].map(|at: usize| all[at].1);
        // The spin is fast enough for two roots.
        let all: Vec<_> = all.iter().map(|(n, x)| (n.clone(), if n == "Omega_q3" { 40.0 * x } else { *x })).collect();
        let form = closed_top();
        let cos = q1.cos() * q2.cos();
        let mut roots = Vec::new();
        for branch in form.list[1].branches.iter().filter(|b| b.solved.len() == 1) {
            let w = value(&branch.solved[0].value.text, &all);
            let n = 40.0 * spin + w * cos;
            let left = a * w * w * cos - c * n * w + m * g * l;
            // The slow root is a difference of two nearly equal numbers.
            let size = (c * n * w).abs().max((c * n).powi(2) / ((a - c) * cos).abs());
            assert!(left.abs() < 1e-12 * size, "{left:e}");
            roots.push(w);
        }
        assert!(roots.len() == 2 && (roots[0] - roots[1]).abs() > 1e-3, "{roots:?}");
    }
    for (model, letters, [of_spin, of_turn]) in
        [("rolling_disc", ["m", "r"], [6.0, 5.0]), ("disk", ["M", "R"], [2.0, 1.0])]
    {
        let form = closed(model, &[]);
        let spin = |branch: &tripos::studies::steady::SolutionBranch| {
            branch.solved.iter().find(|told| told.name.text == "q3'").cloned()
        };
        let formulas: Vec<_> = form.list[1].branches.iter().filter_map(spin).collect();
        assert_eq!(formulas.len(), 1, "{}", in_lines(&form.list[1]));
        for turn in 0..20 {
            let all = numbers(&[letters[0], letters[1], "g", "q1'", "q1", "q2"], turn);
            let [r, g, w, lean] = [1, 2, 3, 5].map(|at: usize| all[at].1);
            let spin = value(&formulas[0].value.text, &all);
            let left = r * w * lean.cos() * (of_spin * spin + of_turn * w * lean.sin()) + 4.0 * g * lean.sin();
            assert!(left.abs() < 1e-12 * g, "{model}: {left:e}");
        }
    }
    let form = closed("governor", &[]);
    for turn in 0..20 {
        let all = numbers(&["l", "m", "mb", "ms", "g", "theta"], turn);
        let [l, m, mb, ms, g, theta] = [0, 1, 2, 3, 4, 5].map(|at: usize| all[at].1);
        let square =
            &form.list[1].branches[0].solved.iter().find(|told| told.name.text == "psi'^2").unwrap().value.text;
        // Half of the total: the moments of a ball, of two rods and of half the sleeve.
        let watt = (m + mb / 2.0 + ms / 2.0) * g / ((mb / 2.0 + m / 3.0) * l * theta.cos());
        assert!((value(square, &all) - watt).abs() < 1e-12 * watt, "{square}");
    }
}

fn closed_top() -> SteadyConditions {
    closed("heavy_top", &["Omega_n3"])
}

fn found(model: &str, state: &str, starts: u64) -> (SteadyConditions, StateWithUnknowns, Vec<FoundMotion>) {
    let mut mechanism = read(model);
    let asked = load_state_with_unknowns(&Source::from_text("state.toml", state), &mut mechanism, &[])
        .unwrap_or_else(|e| panic!("{e}"));
    let found = find_equilibria(&mechanism, &asked, starts).unwrap_or_else(|e| panic!("{e}"));
    (conditions(&mechanism, &[]).unwrap_or_else(|e| panic!("{e}")), asked, found)
}

/// Goal: results of Newton's method lie on a branch, and the branch agrees with them to the last digits. Method:
/// mechanisms at random parameters, from states near; each formula of the branch against the numbers in 32 digits.
#[test]
fn what_newton_finds_lies_on_a_branch() {
    let parameters = |names: &[&str], turn: usize| {
        let list = numbers(names, turn).into_iter().map(|(name, x)| format!("{name} = {x}\n"));
        format!("[parameters]\n{}", list.collect::<String>())
    };
    let mut seen = 0;
    for turn in 0..4 {
        let cases = [
            ("pendulum", parameters(&["m", "l", "g"], turn) + "[state]\ntheta = 2.9\nomega = 0\n"),
            (
                "spherical_pendulum",
                parameters(&["m", "l", "g"], turn) + "[state]\ntheta = 0.6\nu1 = 0\nphi = 0\n[guess]\nu2 = 1\n",
            ),
            (HOOP, parameters(&["m", "r", "J", "g"], turn) + "[state]\npsi = 0\nq = 0.7\nu = 0\n[guess]\nw = 2\n"),
            (
                "elastic_pendulum",
                parameters(&["m", "l", "g", "k"], turn) + "[state]\nx = 0.1\ny = -1.5\nu = 0\nv = 0\n",
            ),
            (
                "rolling_disc",
                parameters(&["r", "m", "g"], turn)
                    + "[state]\nq1 = 0.3\nq2 = 0.4\nq3 = 0\nx = 0\ny = 0\nu1 = 0\nu3 = 1.5\n[guess]\nu2 = -3\n",
            ),
            (
                "heavy_top",
                parameters(&["m", "g"], turn)
                    + "[state]\nq1 = 0.4\nq2 = 0\nq3 = 0\nu1 = 0\nu3 = 40\n[guess]\nu2 = 0.5\n",
            ),
            (DOUBLE, parameters(&["m", "M", "l", "h", "g"], turn) + "[state]\nq1 = 3\nq2 = 0.2\nu1 = 0\nu2 = 0\n"),
        ];
        for (model, state) in &cases {
            let (form, asked, list) = found(model, state, 3);
            for found in &list {
                let BranchesAt { conditions: at, branches } =
                    form.branches_at(&asked.parameters, &found.steady).unwrap();
                let conditions = &form.list[at];
                assert!(!branches.is_empty(), "{state}{:?}\n{}", found.steady, in_lines(conditions));
                let mechanism = read(model);
                let parameters = mechanism.parameters.iter().map(|p| p.name.clone()).zip(&asked.parameters);
                let states = mechanism.coordinates.iter().map(|c| c.name.clone()).zip(&found.steady.x);
                let along = conditions.along.iter().map(|v| v.name.clone()).zip(&found.steady.along);
                let all: Vec<_> = parameters.chain(states).chain(along).map(|(n, x)| (n, x.hi())).collect();
                for told in branches.iter().flat_map(|branch| &conditions.branches[*branch].solved) {
                    let (left, right) = (value(&told.name.text, &all), value(&told.value.text, &all));
                    let turns = ((left - right) / std::f64::consts::TAU).round() * std::f64::consts::TAU;
                    assert!((left - right - turns).abs() < 1e-12 * right.abs().max(1.0), "{told:?}: {left} {right}");
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 40, "{seen}");
}

/// Goal: a motion lies on no branch that contradicts it. Method: a pendulum that stands is not on the branch of one
/// that hangs, and a state off balance is on no branch.
#[test]
fn other_motions_lie_on_no_branch() {
    let (form, asked, list) = found("pendulum", "[state]\ntheta = 3\nomega = 0\n", 0);
    let mut steady = list[0].steady.clone();
    assert_eq!(form.branches_at(&asked.parameters, &steady), Some(BranchesAt { conditions: 0, branches: vec![1] }));
    steady.x[0] = steady.x[0] + tripos_traits::DoubleDouble::from(1e-6);
    assert_eq!(form.branches_at(&asked.parameters, &steady), Some(BranchesAt { conditions: 0, branches: vec![] }));
}

/// Goal: parameters are solved for on request, unknown names are refused, and the work is limited. Method: the radius
/// of a hoop, an unknown name, a driven model, and the bicycle, whose equations are too large.
#[test]
fn what_is_asked_for_is_told_or_refused() {
    let form = closed(HOOP, &["r"]);
    expect_test::expect![[r"
        0 = m*r*sin(q)*(r*psi'^2*cos(q) - g)
        q = 0
        q = pi
        r = g/(psi'^2*cos(q)), cos(q) != 0, psi' != 0"]]
    .assert_eq(&in_lines(&form.list[1]));
    let model = read("pendulum");
    let refused = conditions(&model, &["lenght".to_owned()]).err().unwrap().to_string();
    assert!(refused.contains("`lenght`") && refused.contains("help:"), "{refused}");
    assert!(conditions(&read("driven_pendulum"), &[]).is_err());
    let bicycle = closed("whipple_bicycle", &[]);
    assert!(bicycle.list.iter().all(|c| !c.complete && c.too_large > 0 && c.branches.is_empty()));
}

/// Goal: loops are among the conditions, and are solved where possible. Method: the four-bar linkage keeps its two
/// loops as conditions beside the balance of moments; the governor's four are solved.
#[test]
fn loops_are_conditions() {
    let four_bar = closed("four_bar", &[]);
    expect_test::expect![[r"
        0 = a*g*(sin(q1)*cos(q2)*cos(q3)*(mb + mc) - cos(q1)*(sin(q2)*cos(q3)*(ma + 2*mb + mc) - cos(q2)*sin(q3)*(ma + mb)))/2
        0 = a*cos(q1) - d + b*cos(q2) - c*cos(q3)
        0 = a*sin(q1) + b*sin(q2) - c*sin(q3)
        left sin(q1)*cos(q2)*cos(q3)*(mb + mc) + cos(q1)*(cos(q2)*sin(q3)*(ma + mb) - sin(q2)*cos(q3)*(ma + 2*mb + mc)), left a*cos(q1) - d + b*cos(q2) - c*cos(q3), left a*sin(q1) + b*sin(q2) - c*sin(q3)"]].assert_eq(&in_lines(&four_bar.list[0]));
    let governor = closed("governor", &[]);
    assert!(governor.list[1].branches[0].left.is_empty());
}
