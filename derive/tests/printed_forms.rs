//! Forms in which papers and programs print equations: implicit equations, time derivatives, whole matrices, states in
//! any order, coordinates of the author's own, numbers in the place of parameters.
//!
//! The equations of the cart with a rod are written by hand. They are right where a test says `equal`, and have one
//! slip where it says `different`.

use expect_test::{Expect, expect};
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Difference, judge_publication};
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::load;
use tripos_derive::prove::prove;
use tripos_derive::publication;

/// Cart of mass M on a rail, and a rod of mass m with its mass centre at the distance l from the pin.
pub const CART: &str = r#"
name = "Cart with a rod"
[parameters]
M = { unit = "kg", value = 2, positive = true }
m = { unit = "kg", value = 0.5, positive = true }
l = { unit = "m", value = 0.8, positive = true }
J = { unit = "kg*m^2", value = 0.1, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
[inputs]
F = { unit = "N" }
[coordinates]
x = { unit = "m" }
theta = { unit = "rad" }
[speeds]
v = "x'"
omega = "theta'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "theta" }
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
C = { from = "P", frame = "B", position = [0, "-l", 0] }
[bodies.cart]
frame = "N"
centre = "P"
mass = "M"
inertia = 0
[bodies.rod]
frame = "B"
centre = "C"
mass = "m"
inertia = { diagonal = ["J", 0, "J"] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[forces.push]
on = "cart"
at = "P"
frame = "N"
vector = ["F", 0, 0]
"#;

fn judged(text: &str) -> Difference {
    let mut model = load(&Source::from_text("model.toml", CART)).unwrap_or_else(|e| panic!("{e}"));
    let source = Source::from_text("publication.toml", text);
    let publication = publication::load_publication(&source, &mut model).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    judge_publication(&model, &mut derivations, &publication, &proof)
}

/// A line for each finding: id, verdict, what it holds up to, and the mistake.
fn check(text: &str, expected: &Expect) {
    let lines: Vec<String> = judged(text)
        .findings
        .iter()
        .map(|f| {
            let parts = [f.up_to.map(str::to_owned), f.wrong.clone()];
            let parts: Vec<String> = parts.into_iter().flatten().collect();
            [vec![format!("{} {}", f.id, f.judgement.word())], parts].concat().join(": ")
        })
        .collect();
    expected.assert_eq(&lines.join("\n"));
}

fn equation(id: &str, printed: &str) -> String {
    format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nprinted = '{printed}'\n")
}

#[test]
fn equations_of_motion_are_read_as_they_are_printed() {
    let text = [
        "notation = \"latex\"\n".to_owned(),
        equation("cart", r"(M + m)\ddot x + m l\ddot\theta\cos\theta - m l\dot\theta^2\sin\theta = F"),
        equation("rod", r"(J + m l^2)\ddot\theta + m l\cos\theta\,\ddot x + m g l\sin\theta = 0"),
        equation("times", r"\ddot\theta + \frac{m l\cos\theta}{J + m l^2}\ddot x = -\frac{m g l}{J + m l^2}\sin\theta"),
        equation(
            "quotients",
            r"(M + m)\frac{d^2 x}{dt^2} + m l\frac{d^2\theta}{dt^2}\cos\theta(t) = F + m l\left(\frac{\mathrm{d}\theta}{\mathrm{d}t}\right)^2\sin\theta",
        ),
        equation("momentum", r"\frac{d}{dt}\left((M + m)\dot x + m l\dot\theta\cos\theta\right) = F"),
        equation("sign", r"(M + m)\ddot x + m l\ddot\theta\cos\theta + m l\dot\theta^2\sin\theta = F"),
        equation("bare", r"(M + m)\ddot x + m l\ddot\theta\cos\theta - m l\sin\theta\dot\theta^2 = F"),
    ];
    check(
        &text.concat(),
        &expect![[r"
        cart equal
        rod equal
        times scaled
        quotients equal
        momentum equal
        sign different: in the right-hand side, the term -m*l*theta'^2*sin(theta) should be m*l*theta'^2*sin(theta)
        bare equal"]],
    );
}

#[test]
fn a_system_may_be_equations_and_have_accelerations_on_the_right() {
    let text = r#"
[[system]]
id = "both"
section = "1"
formulation = "lagrange"
equations = ["(M + m)*x'' = F - m*l*(theta''*cos(theta) - theta'^2*sin(theta))", "ddt((J + m*l^2)*theta') + m*l*cos(theta)*x'' = -m*g*l*sin(theta)"]
[[system]]
id = "moved"
section = "1"
formulation = "kane"
unknowns = ["v'", "omega'"]
matrix = [["M + m", 0], [0, "J + m*l^2"]]
right = ["F - m*l*(omega'*cos(theta) - omega^2*sin(theta))", "-m*l*(v'*cos(theta) + g*sin(theta))"]
"#;
    check(
        text,
        &expect![[r"
        both-row1 equal
        both-row2 equal
        moved-row1 equal
        moved-row2 equal"]],
    );
}

#[test]
fn whole_matrices_are_judged_entry_by_entry() {
    let text = r#"
[[matrix]]
id = "M"
section = "1"
notation = "latex"
quantity = "M"
printed = '\begin{bmatrix} M + m & m l \cos\theta \\ m l \sin\theta & J + m l^2 \end{bmatrix}'
[[matrix]]
id = "f"
section = "1"
notation = "python"
quantity = "f"
printed = "np.array([F + m*l*omega**2*np.sin(theta), -m*g*l*np.sin(theta)])"
[[matrix]]
id = "E"
section = "1"
notation = "matlab"
quantity = "E"
printed = "[M+m m*l*cos(theta); m*l*cos(theta) J+m*l^2]"
"#;
    check(
        text,
        &expect![[r"
        M-11 equal
        M-12 equal
        M-21 different: m*l*sin(theta) should be m*l*cos(theta)
        M-22 equal
        f-11 equal
        f-12 equal
        E-11 equal
        E-12 equal
        E-21 equal
        E-22 equal"]],
    );
}

/// Programs write states in any order and number, and names in their own way.
#[test]
fn states_and_names_are_those_of_programs() {
    let text = r#"
[symbols]
"p['m']" = "m"
"x[2][0]" = "theta"
"θ̇" = "theta'"
[[listing]]
id = "part"
section = "1"
formulation = "kane"
state = ["theta", "omega", "v"]
derivative = ["omega", "-m*l*g*sin(theta)", "F + m*l*omega^2*sin(theta)"]
matrix = [["J + m*l^2", "m*l*cos(theta)"], ["m*l*cos(theta)", "M + m"]]
[[equation]]
id = "python"
section = "1"
notation = "python"
quantity = "V"
printed = "-p['m']*g*l*ca.cos(x[2][0])"
[[equation]]
id = "c"
section = "1"
notation = "c"
quantity = "V"
printed = "-m*g*l*cosf(theta)"
[[equation]]
id = "unicode"
section = "1"
quantity = "T"
printed = "(M + m)·x'²/2 + m·l·x'·θ'·cos(θ) + (J + m·l²)·θ'²/2"
[[equation]]
id = "dot"
section = "1"
quantity = "H(rod) @ N [3]"
notation = "python"
printed = "J*θ̇"
"#;
    check(
        text,
        &expect![[r"
        part-dz1 equal
        part-E12 equal
        part-E11 equal
        part-dz2 equal
        part-E22 equal
        part-E21 equal
        part-dz3 equal
        python equal
        c equal
        unicode equal
        dot equal"]],
    );
}

/// An author's angle from the upright, α = θ − π, and the place of the rod's centre, s = x + l sin θ.
#[test]
fn coordinates_of_the_author_are_differentiated() {
    let text = r#"
[coordinates]
alpha = "theta - pi"
s = "x + l*sin(theta)"
[[equation]]
id = "V"
section = "1"
quantity = "V"
printed = "m*g*l*cos(alpha)"
[[equation]]
id = "v"
section = "1"
quantity = "v(C) @ N [1]"
printed = "s'"
[[equation]]
id = "newton"
section = "1"
printed = "M*x'' + m*s'' = F"
[[equation]]
id = "wrong"
section = "1"
printed = "M*x'' + m*x'' = F"
[[system]]
id = "own"
section = "1"
formulation = "lagrange"
unknowns = ["x''", "alpha''"]
matrix = [["M + m", "-m*l*cos(alpha)"], ["-m*l*cos(alpha)", "J + m*l^2"]]
right = ["F - m*l*alpha'^2*sin(alpha)", "m*g*l*sin(alpha)"]
"#;
    check(
        text,
        &expect![[r"
        V equal
        v equal
        newton equal
        wrong different: in the coefficient of theta'', 0 should be m*l*cos(theta); in the right-hand side, F should be m*l*theta'^2*sin(theta) + F
        own-row1 equal
        own-row2 equal"]],
    );
}

/// M = 2.5 kg, m l = 0.4 kg m, J + m l² = 0.42 kg m², m g l = 3.924 N m at the default values.
#[test]
fn numbers_stand_for_parameters_to_the_digits_printed() {
    let text = r#"
[[system]]
id = "numbers"
section = "1"
formulation = "kane"
unknowns = ["v'", "omega'"]
matrix = [["2.5", "0.4*cos(theta)"], ["0.4*cos(theta)", "0.42"]]
right = ["F + 0.4*omega^2*sin(theta)", "-3.92*sin(theta)"]
[[equation]]
id = "right"
section = "1"
quantity = "V"
printed = "-3.92*cos(theta)"
[[equation]]
id = "wrong"
section = "1"
quantity = "V"
printed = "-3.91*cos(theta)"
"#;
    check(
        text,
        &expect![[r"
        numbers-row1 equal: to the digits printed
        numbers-row2 equal: to the digits printed
        right equal: to the digits printed
        wrong different"]],
    );
}

#[test]
fn what_does_not_count_is_accepted_and_said() {
    let text = r#"
[[equation]]
id = "zero"
section = "1"
quantity = "V"
printed = "m*g*l*(1 - cos(theta))"
[[equation]]
id = "rate"
section = "1"
quantity = "L"
printed = "(M + m)*x'^2/2 + m*l*x'*theta'*cos(theta) + (J + m*l^2)*theta'^2/2 + m*g*l*cos(theta) + m*l*sqrt(g/l)*(x'*sin(theta) + x*theta'*cos(theta))"
[[equation]]
id = "left"
section = "1"
quantity = "V"
printed = "V = -m*g*l*cos(theta)"
notation = "tripos"
"#;
    check(
        text,
        &expect![[r"
        zero equal: up to a constant
        rate equal: up to a time derivative
        left equal"]],
    );
}

/// The mistake is named, and no factor in coordinates is made up.
#[test]
fn rows_are_matched_as_they_were_meant() {
    let row = |id: &str, printed: &str| {
        format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\nformulation = \"kane\"\nprinted = \"{printed}\"\n")
    };
    let text = [
        row("half", "(m*l*cos(theta)*v' + J*omega')/2 = -m*g*l*sin(theta)/2"),
        row("moment", "m*l*cos(theta)*v' + J*omega' = -m*g*l*sin(theta)"),
        row("term", "m*l*cos(theta)*v' + (J + m*l^2)*omega' = -m*g*l*sin(theta) - m*l*v*omega*sin(theta)"),
        row(
            "combined",
            "(M + m + m*l*cos(theta))*v' + (J + m*l^2 + m*l*cos(theta))*omega' = F + 2*m*l*omega^2*sin(theta) - m*g*l*sin(theta)",
        ),
        row("dot", "(M + m)*v' + m*l*omega'*cos(theta) = F + m*l*theta^2*sin(theta)"),
        row("scaled", "v' + m*l/(M + m)*omega'*cos(theta) = (F + m*l*omega^2*sin(theta))/(M + m)"),
    ];
    check(
        &text.concat(),
        &expect![[r"
        half different: in the coefficient of omega', the term m*l^2/2 is missing
        moment different: in the coefficient of omega', J should be m*l^2 + J
        term different: in the right-hand side, the term -m*l*v*omega*sin(theta) should not be there
        combined different: in the right-hand side, the term 2*m*l*omega^2*sin(theta) should be m*l*omega^2*sin(theta)
        dot different: in the right-hand side, m*l*theta^2*sin(theta) should be m*l*theta'^2*sin(theta)
        scaled scaled"]],
    );
}

/// Goal: a hostile publication costs bounded time and memory. Method: the longest file of wrong entries, and
/// derivatives of an order that nobody writes.
#[test]
fn a_hostile_publication_costs_bounded_time() {
    let terms: Vec<String> = (1..60).map(|k| format!("m*l*{k}.5*sin({k}*theta)*cos(theta + {k})")).collect();
    let long = terms.join(" + ");
    let entry = |at: usize| {
        format!("[[equation]]\nid = \"e{at}\"\nsection = \"1\"\nquantity = \"V\"\nprinted = \"{long} + {at}*m*g*l\"\n")
    };
    let start = std::time::Instant::now();
    let difference = judged(&(0..100).map(entry).collect::<String>());
    assert!(difference.findings.iter().all(|finding| finding.judgement.word() == "different"));
    assert!(start.elapsed().as_secs() < 120, "{:?}", start.elapsed());
    let mut model = load(&Source::from_text("model.toml", CART)).unwrap_or_else(|e| panic!("{e}"));
    let text = format!("notation = \"latex\"\n{}", equation("d", r"\frac{d^{99999999} x}{dt^{99999999}} = 0"));
    let error = publication::load_publication(&Source::from_text("publication.toml", &text), &mut model)
        .unwrap_err()
        .to_string();
    assert!(error.contains("unknown symbol `d`"), "{error}");
}
