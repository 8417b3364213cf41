//! Goal: every quantity that a publication names has the value of its textbook definition. Method: values are proved
//! equal to formulas worked by hand.

use super::Quantities;
use crate::algebra::meaning::compare::{Comparer, Verdict};
use crate::algebra::text::parse::parse_primed;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::Source;
use crate::mechanics::quantity::Quantity;
use crate::mechanics::{Derivations, derive_all, newton_euler_balances};
use crate::model::{Model, load};
use std::path::Path;

const PENDULUM: &str = r#"
    name = "Pendulum with a slider and two loads"
    [parameters]
    m = { unit = "kg", positive = true }
    k = { unit = "N/m" }
    b = { unit = "N*m*s" }
    l = { unit = "m", positive = true }
    I = { unit = "kg*m^2", positive = true }
    g = { unit = "m/s^2" }
    [coordinates]
    x = { unit = "m" }
    q = { unit = "rad" }
    [speeds]
    u1 = "x'"
    w = "q' + x'/l"
    [inertial]
    frame = "N"
    origin = "O"
    [frames]
    A = { from = "N", axis = 3, angle = "q" }
    [points]
    P = { from = "O", frame = "N", position = ["x", 0, 0] }
    C = { from = "P", frame = "A", position = [0, "-l", 0] }
    [particles]
    cart = { point = "P", mass = "m" }
    [bodies.rod]
    frame = "A"
    centre = "C"
    mass = "m"
    inertia = { diagonal = ["I", 0, "I"] }
    [gravity]
    frame = "N"
    acceleration = [0, "-g", 0]
    [forces.spring]
    on = "cart"
    frame = "N"
    vector = ["-k*x", 0, 0]
    [forces.push]
    on = "rod"
    at = "P"
    frame = "N"
    vector = ["k*l", 0, 0]
    [torques.damper]
    on = "A"
    frame = "A"
    vector = [0, 0, "-b*q'"]
"#;

pub(super) fn disk() -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/disk/model.toml");
    Model::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

pub(super) fn pendulum() -> Model {
    load(&Source::from_text("pendulum.toml", PENDULUM)).unwrap_or_else(|e| panic!("{e}"))
}

fn derived(model: &Model) -> Derivations {
    derive_all(model).unwrap_or_else(|e| panic!("{e}"))
}

fn formula(arena: &mut Arena, text: &str) -> Expr {
    let resolve = &mut |arena: &mut Arena, name: &str| {
        arena.find_symbol(name).ok_or_else(|| (format!("{name} is no name of the model"), None))
    };
    parse_primed(arena, text, 2, resolve).unwrap_or_else(|e| panic!("{text}: {}", e.message))
}

fn value(quantities: &mut Quantities<'_>, name: &str) -> Expr {
    let quantity = Quantity::parse(name, quantities.model).unwrap_or_else(|e| panic!("{name}: {}", e.message));
    quantities.value(&quantity).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn assert_equal(quantities: &mut Quantities<'_>, name: &str, left: Expr, right: Expr) {
    let verdict = Comparer::default().compare(&mut quantities.derivations.kinematics.arena, left, right);
    assert!(matches!(verdict, Verdict::Equal(_)), "{name}: {verdict:?}");
}

fn check(model: &Model, truths: &[(&str, &str)]) {
    let mut derivations = derived(model);
    let mut quantities = Quantities::new(model, &mut derivations);
    for (name, truth) in truths {
        let left = value(&mut quantities, name);
        let right = formula(&mut quantities.derivations.kinematics.arena, truth);
        assert_equal(&mut quantities, &format!("{name} = {truth}"), left, right);
    }
}

#[test]
fn kinematics_of_the_disk_are_those_worked_by_hand() {
    check(
        &disk(),
        &[
            ("rotation(A, H) [1,2]", "sin(q1)"),
            ("rotation(A, H) [2,1]", "-sin(q1)"),
            ("rotation(H, B) [3,2]", "-cos(q2)"),
            ("rotation(B, C) [1,2]", "-cos(q3)"),
            ("p(Cstar) @ A [1]", "q4 + R*sin(q1)*(-sin(q2))"),
            ("p(Cstar) @ A [2]", "q5 + R*cos(q1)*sin(q2)"),
            ("p(Cstar) @ A [3]", "R*cos(q2)"),
            ("omega(B) @ B [3]", "u2*tan(q2)"),
            ("omega(C) @ B [1]", "u1"),
            ("omega(C) @ B [2]", "u2"),
            ("omega(C) @ B [3]", "u3"),
            ("v(Cstar) @ B [1]", "-R*u2*tan(q2) + u4*cos(q1) + u5*sin(q1)"),
            ("v(Cstar) @ B [2]", "sin(q2)*(u5*cos(q1) - u4*sin(q1))"),
            ("v(Cstar) @ B [3]", "R*u1 + cos(q2)*(u4*sin(q1) - u5*cos(q1))"),
            ("alpha(C) @ B [1]", "u1' + u2*(u3 - u2*tan(q2))"),
            ("alpha(C) @ B [2]", "u2' - u1*(u3 - u2*tan(q2))"),
            ("alpha(C) @ B [3]", "u3'"),
            ("a(Cstar) @ B [2]", "sin(q2)*(u5'*cos(q1) - u4'*sin(q1)) - R*u1^2 - R*u2^2*tan(q2)^2"),
            ("d v(Cstar) @ B [1]/d u2", "-R*tan(q2)"),
            ("d v(Cstar) @ B [3]/d u4", "sin(q1)*cos(q2)"),
            ("d omega(C) @ B [1]/d u1", "1"),
            ("d omega(C) @ B [1]/d u4", "0"),
            ("u1", "-q2'"),
            ("u3", "q1'*sin(q2) + q3'"),
            ("q1'", "u2/cos(q2)"),
            ("q2'", "-u1"),
            ("q3'", "u3 - u2*tan(q2)"),
        ],
    );
}

#[test]
fn loads_energies_and_generalized_forces_of_the_disk_are_those_worked_by_hand() {
    check(
        &disk(),
        &[
            ("I(disk) @ B [1,1]", "M*R^2/4"),
            ("I(disk) @ B [1,2]", "0"),
            ("I(disk) @ H [2,2]", "M*R^2/4*(sin(q2)^2 + 2*cos(q2)^2)"),
            ("I(disk) @ H [2,3]", "-M*R^2/4*sin(q2)*cos(q2)"),
            ("I(disk) @ C [3,3]", "M*R^2/2"),
            // omega_B = (u1, u2, u2 tan q2) and H = M R^2/4 (u1, u2, 2 u3): dH/dt = M R^2/4 (u1', u2', 2 u3') +
            // omega_B x H.
            ("H(disk) @ B [3]", "M*R^2/2*u3"),
            ("Hdot(disk) @ B [1]", "M*R^2/4*(u1' + 2*u2*u3 - u2^2*tan(q2))"),
            ("Hdot(disk) @ B [3]", "M*R^2/2*u3'"),
            ("Tstar(disk) @ B [2]", "-M*R^2/4*(u2' - 2*u1*u3 + u1*u2*tan(q2))"),
            ("Rstar(disk) @ B [2]", "-M*(sin(q2)*(u5'*cos(q1) - u4'*sin(q1)) - R*u1^2 - R*u2^2*tan(q2)^2)"),
            ("weight(disk) @ H [3]", "-M*g"),
            ("weight(disk) @ B [2]", "-M*g*cos(q2)"),
            ("force(disk) @ B [2]", "(N - M*g)*cos(q2)"),
            ("force(disk) @ A [3]", "N - M*g"),
            ("moment(disk) @ B [1]", "-N*R*sin(q2)"),
            ("moment(disk) @ B [2]", "0"),
            ("F[1]", "-M*g*R*sin(q2)"),
            ("F[u2]", "0"),
            ("Fstar[3]", "-M*R^2/2*u3'"),
            ("T_rotation", "M*R^2/8*(u1^2 + u2^2 + 2*u3^2)"),
            ("V", "-M*g*R*(1 - cos(q2))"),
        ],
    );
}

#[test]
fn a_model_with_loads_and_a_particle_agrees_with_hand_calculation() {
    check(
        &pendulum(),
        &[
            ("q'", "w - u1/l"),
            ("v(C) @ N [1]", "u1 + l*cos(q)*(w - u1/l)"),
            ("omega(A) @ N [3]", "w - u1/l"),
            ("alpha(A) @ N [3]", "w' - u1'/l"),
            ("force(cart) @ N [1]", "-k*x"),
            ("force(rod) @ N [1]", "k*l"),
            ("force(rod) @ N [2]", "-m*g"),
            // The push acts at P, which lies at the distance l along a2 from C: r × F = l a2 × k l n1.
            ("moment(rod) @ A [3]", "-b*(w - u1/l) - k*l^2*cos(q)"),
            ("I(rod) @ N [1,1]", "I*cos(q)^2"),
            ("I(rod) @ N [1,2]", "I*sin(q)*cos(q)"),
            ("Rstar(cart) @ N [1]", "-m*u1'"),
            ("weight(cart) @ N [2]", "-m*g"),
            ("T_translation", "m*u1^2/2 + m/2*((u1 + (l*w - u1)*cos(q))^2 + ((l*w - u1)*sin(q))^2)"),
            ("T_rotation", "I/2*(w - u1/l)^2"),
            ("V_gravity", "-m*g*l*cos(q)"),
            // The spring of the cart, and the push, whose point moves with the cart.
            ("V", "-m*g*l*cos(q) + k*(x - l)^2/2"),
            ("E[1,1]", "2*m"),
            ("E[q,q]", "m*l^2 + I"),
            ("E[x,q]", "m*l*cos(q)"),
            ("A[x]", "m*l*sin(q)*q'^2 - k*x + k*l"),
            ("A[2]", "-m*g*l*sin(q) - b*q'"),
        ],
    );
}

/// Goal: quantities are consistent. Method: F + F* = 0 is M u̇ = f, term by term; M and E are symmetric; T, L and the
/// energy add up.
#[test]
fn the_quantities_fit_together() {
    for model in [disk(), pendulum()] {
        let mut derivations = derived(&model);
        let mut q = Quantities::new(&model, &mut derivations);
        let n = model.speeds.len();
        for r in 1..=n {
            let (f, f_star) = (value(&mut q, &format!("F[{r}]")), value(&mut q, &format!("Fstar[{r}]")));
            let left = q.derivations.kinematics.arena.add(f, f_star);
            let mut right = value(&mut q, &format!("f[{r}]"));
            for s in 1..=n {
                let entry = value(&mut q, &format!("M[{r},{s}]"));
                let transposed = value(&mut q, &format!("M[{s},{r}]"));
                assert_equal(&mut q, "M symmetric", entry, transposed);
                let entry_e = value(&mut q, &format!("E[{r},{s}]"));
                let transposed = value(&mut q, &format!("E[{s},{r}]"));
                assert_equal(&mut q, "E symmetric", entry_e, transposed);
                let arena = &mut q.derivations.kinematics.arena;
                let product = arena.mul(entry, model.speeds[s - 1].rate);
                right = arena.sub(right, product);
            }
            assert_equal(&mut q, "F + F* = f - M u'", left, right);
        }
        for (sum, a, b) in [("T", "T_translation", "T_rotation"), ("energy", "T", "V"), ("T", "L", "V")] {
            let (total, a, b) = (value(&mut q, sum), value(&mut q, a), value(&mut q, b));
            let both = q.derivations.kinematics.arena.add(a, b);
            assert_equal(&mut q, sum, total, both);
        }
    }
}

/// Goal: loads have the signs of the balances m a − ΣF and dH/dt − ΣM. Method: comparison with each balance.
#[test]
fn loads_and_inertia_loads_are_those_of_the_newton_euler_balances() {
    for mut model in [disk(), pendulum()] {
        // Sums of forces and moments contain only the reactions that the model file states.
        model.reactions.truncate(model.stated_reactions().len());
        let mut derivations = derived(&model);
        let velocities = derivations.kinematics.in_speeds(&model);
        let balances = newton_euler_balances(&model, &mut derivations.kinematics, &velocities, Some(1));
        let mut q = Quantities::new(&model, &mut derivations);
        for balance in balances {
            let place = format!(
                "({}) @ {} [{}]",
                model.bodies[balance.name.body].name,
                model.frames[1].name,
                balance.name.axis + 1
            );
            let (inertia, load) = if balance.name.moments { ("Tstar", "moment") } else { ("Rstar", "force") };
            let terms = [value(&mut q, &format!("{inertia}{place}")), value(&mut q, &format!("{load}{place}"))];
            let sum = q.derivations.kinematics.arena.sum(&terms);
            let opposite = q.derivations.kinematics.arena.neg(sum);
            assert_equal(&mut q, &format!("{load}{place}"), balance.residual, opposite);
        }
    }
}

/// Goal: rewriting a term in rates and back in speeds gives the same term. Method: an acceleration of the disk.
#[test]
fn rates_and_speeds_translate_both_ways() {
    let model = disk();
    let mut derivations = derived(&model);
    let mut q = Quantities::new(&model, &mut derivations);
    let a = value(&mut q, "a(Cstar) @ B [1]");
    assert!(q.mentions_speeds(a) && !q.mentions_rates(a));
    let there = q.in_rates(a);
    assert!(!q.mentions_speeds(there) && q.mentions_rates(there));
    let second = formula(&mut q.derivations.kinematics.arena, "q1''");
    assert!(q.derivations.kinematics.arena.mentions(there, second));
    let back = q.in_speeds(there);
    assert!(q.mentions_speeds(back) && !q.mentions_rates(back));
    assert_equal(&mut q, "there and back", a, back);
    let truth = formula(&mut q.derivations.kinematics.arena, "-q2''");
    let rate = formula(&mut q.derivations.kinematics.arena, "u1'");
    let rate = q.in_rates(rate);
    assert_equal(&mut q, "u1'", rate, truth);
}
