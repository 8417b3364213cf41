//! Forces act on the material of bodies, at points that may move in them: their power, and the velocities in formulas.
//!
//! Truth by hand for the disk, whose lowest point P stays the lowest while the rim turns. The material there has the
//! velocity of P plus R u₃ along h1, so that drag on it has the power −c |v|².

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::common::{BASE, edited, errors, read};
use expect_test::{Expect, expect};
use tripos_derive::algebra::meaning::compare::{Comparer, Verdict};
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Quantities, Quantity, derive_all, moving_load_places, rates_to_speeds};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model, derive};

const DISK: &str = include_str!("models/dragged_disk.toml");

/// The disk with one force on it at P, in the frame A.
fn disk(force: &str) -> Model {
    let (before, _) = DISK.split_once("[forces.film]").unwrap();
    let (_, after) = DISK.split_once("[reactions.N]").unwrap();
    let force = format!("[forces.film]\non = \"disk\"\nat = \"P\"\nframe = \"A\"\nvector = {force}\n");
    read(&format!("{before}{force}[reactions.N]{after}")).unwrap_or_else(|e| panic!("{e}"))
}

const DRAG: &str = "[\"-c*v(disk, P) @ A [1]\", \"-c*v(disk, P) @ A [2]\", 0]";

fn value(quantities: &mut Quantities<'_>, name: &str) -> Expr {
    let quantity = Quantity::parse(name, quantities.model).unwrap_or_else(|e| panic!("{name}: {}", e.message));
    quantities.value(&quantity).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn same(arena: &mut Arena, left: Expr, right: Expr) {
    let verdict = Comparer::default().compare(arena, left, right);
    assert!(verdict.is_equal(), "{} and {}: {verdict:?}", print_text(arena, left), print_text(arena, right));
}

/// Σ Q_i q̇_i of everything but gravity, in q and u.
fn power(model: &Model, quantities: &mut Quantities<'_>) -> Expr {
    let kinematics = &mut quantities.derivations.kinematics;
    let forces = kinematics.load_potential(model).rest;
    let arena = &mut kinematics.arena;
    let terms: Vec<Expr> = forces.iter().zip(model.q_dot()).map(|(force, rate)| arena.mul(*force, rate)).collect();
    let sum = arena.sum(&terms);
    rates_to_speeds(model).apply(arena, sum)
}

#[test]
fn the_material_of_the_disk_has_the_velocity_of_the_rim() {
    let model = disk(DRAG);
    let mut derivations = derive_all(&model).unwrap();
    let mut quantities = Quantities::new(&model, &mut derivations);
    let of_point = value(&mut quantities, "v(Cstar) @ B [1]");
    let of_material = value(&mut quantities, "v(disk, Cstar) @ B [1]");
    same(&mut quantities.derivations.kinematics.arena, of_material, of_point);
    for (name, truth) in [
        ("v(P) @ H [1]", "u4*cos(q1) + u5*sin(q1)"),
        ("v(disk, P) @ H [1]", "u4*cos(q1) + u5*sin(q1) + R*(u3 - u2*tan(q2))"),
        ("v(disk, P) @ H [2]", "-u4*sin(q1) + u5*cos(q1)"),
        ("v(disk, P) @ A [3]", "0"),
    ] {
        let left = value(&mut quantities, name);
        let arena = &mut quantities.derivations.kinematics.arena;
        let right = parse_free(arena, truth).unwrap();
        same(arena, left, right);
    }
}

/// Goal: a force works on the material. Method: the generalized forces of Lagrange's equations times the rates against
/// F · v, by exact verdict; and the power at random states.
#[test]
fn drag_on_the_material_takes_power_and_drag_on_the_point_may_give_it() {
    let model = disk(DRAG);
    let mut derivations = derive_all(&model).unwrap();
    let mut quantities = Quantities::new(&model, &mut derivations);
    let power_of_drag = power(&model, &mut quantities);
    let (x, y) = (value(&mut quantities, "v(disk, P) @ A [1]"), value(&mut quantities, "v(disk, P) @ A [2]"));
    let arena = &mut quantities.derivations.kinematics.arena;
    let c = arena.symbol("c");
    let squares = [arena.square(x), arena.square(y)];
    let square = arena.sum(&squares);
    let product = arena.mul(c, square);
    let expected = arena.neg(product);
    same(arena, power_of_drag, expected);
    assert!(highest(&model, arena, power_of_drag) <= 0.0);

    // Drag along the way of the contact point is no drag on the disk.
    let model = disk("[\"-c*v(P) @ A [1]\", \"-c*v(P) @ A [2]\", 0]");
    let mut derivations = derive_all(&model).unwrap();
    let mut quantities = Quantities::new(&model, &mut derivations);
    let along_the_point = power(&model, &mut quantities);
    assert!(highest(&model, &quantities.derivations.kinematics.arena, along_the_point) > 0.0);
}

/// The largest value at 200 seeded states.
fn highest(model: &Model, arena: &Arena, e: Expr) -> f64 {
    let tape = Tape::new(arena, &[model.p(), model.q(), model.u()].concat(), &[e]).unwrap();
    let (p, mut seed) = ([1.0, 0.7, 9.81, 0.3, 0.1], 1_u64);
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 40) as f64 / (1_u64 << 23) as f64 - 1.0
    };
    let states = (0..200).map(|_| [p.to_vec(), (0..10).map(|_| draw()).collect()].concat());
    states.map(|state| tape.evaluate(&state)[0]).fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn the_three_formulations_agree_on_loads_at_moving_points() {
    for model in [disk(DRAG), read(DISK).unwrap()] {
        let mut derivations = derive_all(&model).unwrap();
        let proof = prove(&model, &mut derivations);
        assert_eq!(proof.pairs.len(), 3, "{:?}", proof.missing);
        for pair in &proof.pairs {
            assert!(matches!(pair.verdict, Verdict::Equal(_)), "{:?}", (pair.left, pair.right));
        }
    }
}

/// A point of the body moves as its material: which of the two is named changes no term.
#[test]
fn at_a_point_fixed_in_the_body_both_names_are_the_same() {
    let with = |name: &str| {
        let damper = format!(
            "[forces.damper]\non = \"rod\"\nat = \"T\"\nagainst = \"cart\"\nframe = \"N\"\nvector = [\"-c*{name} @ N [1]\", 0, 0]\n"
        );
        let point = "[points]\nT = { from = \"C\", frame = \"A\", position = [0, \"-length\", 0] }\n";
        let c = "c = { unit = \"N*s/m\", value = 1 }\ng =";
        let model = read(&edited(&[("[points]\n", point), ("g =", c)], &damper)).unwrap_or_else(|e| panic!("{e}"));
        let derivation = derive(&model, Formulation::Kane).unwrap();
        let texts = derivation.equations.forcing.iter().map(|e| print_text(&derivation.arena, *e));
        (texts.collect::<Vec<_>>(), moving_load_places(&model).unwrap())
    };
    let (by_point, by_material) = (with("v(T)"), with("v(rod, T)"));
    assert_eq!(by_point.0, by_material.0);
    assert!(by_point.0[1].contains('c') && by_point.1.is_empty() && by_material.1.is_empty());
    let by_rates = with("(x' + 2*length*q'*cos(q)) + 0*v(T)");
    assert_eq!(by_point.0, by_rates.0);
}

#[test]
fn what_is_said_of_loads_at_moving_points() {
    let model = disk(DRAG);
    let said: Vec<String> = moving_load_places(&model).unwrap().iter().map(|place| place.text(&model)).collect();
    expect![[r"
        The force film acts on the material of disk that is at P: P moves in disk, so that power is taken with v(disk, P), not with v(P).
        The reaction N acts on the material of disk that is at P: P moves in disk, so that power is taken with v(disk, P), not with v(P)."]]
    .assert_eq(&said.join("\n"));
}

/// Goal: a reaction that works on the material is refused. Method: along a1 the rim moves where the contact point
/// stands still, since the disk spins.
#[test]
fn a_reaction_that_works_on_the_material_is_refused() {
    let along = DISK.replace("direction = [\"0\", \"0\", \"1\"]", "direction = [\"1\", \"0\", \"0\"]");
    let said = errors(&along).to_string();
    assert!(said.contains("the reaction `N` does work along `q3`"), "{said}");
}

fn check(force: &str, expected: &Expect) {
    let damper = format!("[forces.damper]\non = \"rod\"\nframe = \"N\"\nvector = [{force}, 0, 0]\n");
    let text = edited(&[("g =", "c = { unit = \"N*s/m\", value = 1 }\ng =")], &damper);
    let lines = errors(&text).to_string();
    let lines: Vec<&str> = lines.lines().map(str::trim_end).collect();
    expected.assert_eq(&lines.join("\n"));
}

#[test]
fn every_wrong_name_of_a_velocity_is_said_at_once() {
    check(
        "\"-c*v(rood, Q) @ M [1] - c*v(A) @ C [2]\"",
        &expect![[r#"
        error: there is no body `rood`
          --> model.toml:44:17
           |
        44 | vector = ["-c*v(rood, Q) @ M [1] - c*v(A) @ C [2]", 0, 0]
           |                 ^^^^
           |
           = help: did you mean `rod`?

        error: there is no point `Q`
          --> model.toml:44:23
           |
        44 | vector = ["-c*v(rood, Q) @ M [1] - c*v(A) @ C [2]", 0, 0]
           |                       ^
           |
           = help: known here: `O`, `P`, `C`

        error: there is no frame `M`
          --> model.toml:44:28
           |
        44 | vector = ["-c*v(rood, Q) @ M [1] - c*v(A) @ C [2]", 0, 0]
           |                            ^
           |
           = help: known here: `N`, `A`

        error: `A` is a frame, not a point
          --> model.toml:44:40
           |
        44 | vector = ["-c*v(rood, Q) @ M [1] - c*v(A) @ C [2]", 0, 0]
           |                                        ^
           |
           = help: known here: `O`, `P`, `C`

        error: `C` is a point, not a frame
          --> model.toml:44:45
           |
        44 | vector = ["-c*v(rood, Q) @ M [1] - c*v(A) @ C [2]", 0, 0]
           |                                             ^
           |
           = help: known here: `N`, `A`"#]],
    );
}

#[test]
fn a_velocity_has_the_form_of_one() {
    check(
        "\"-c*v(P) @ N [4]\"",
        &expect![[r#"
        error: there is no component `4`
          --> model.toml:44:25
           |
        44 | vector = ["-c*v(P) @ N [4]", 0, 0]
           |                         ^
           |
           = help: components are 1, 2 and 3"#]],
    );
    check(
        "\"-c*v(P) [1]\"",
        &expect![[r#"
            error: `@` is missing here
              --> model.toml:44:20
               |
            44 | vector = ["-c*v(P) [1]", 0, 0]
               |                    ^
               |
               = help: write v(POINT) @ FRAME [1], v(BODY, POINT) @ FRAME [1] for the material of a body, omega(BODY) @ FRAME [1], or p(POINT) @ FRAME [1] for a position"#]],
    );
    check(
        "\"-c*v(P, rod) @ N [1]\"",
        &expect![[r#"
        error: `P` is a point, not a body
          --> model.toml:44:17
           |
        44 | vector = ["-c*v(P, rod) @ N [1]", 0, 0]
           |                 ^
           |
           = help: known here: `rod`, `cart`

        error: `rod` is a body, not a point
          --> model.toml:44:20
           |
        44 | vector = ["-c*v(P, rod) @ N [1]", 0, 0]
           |                    ^^^
           |
           = help: known here: `O`, `P`, `C`"#]],
    );
    check(
        "\"-c*v(rod, P, C) @ N [1]\"",
        &expect![[r#"
            error: `)` is missing here
              --> model.toml:44:23
               |
            44 | vector = ["-c*v(rod, P, C) @ N [1]", 0, 0]
               |                       ^
               |
               = help: write v(POINT) @ FRAME [1], v(BODY, POINT) @ FRAME [1] for the material of a body, omega(BODY) @ FRAME [1], or p(POINT) @ FRAME [1] for a position"#]],
    );
    check(
        "\"-c*v() @ N [1]\"",
        &expect![[r#"
            error: a point is missing here
              --> model.toml:44:17
               |
            44 | vector = ["-c*v() @ N [1]", 0, 0]
               |                 ^
               |
               = help: write v(POINT) @ FRAME [1], v(BODY, POINT) @ FRAME [1] for the material of a body, omega(BODY) @ FRAME [1], or p(POINT) @ FRAME [1] for a position"#]],
    );
    check(
        "\"-c*v(P) @ N [1\"",
        &expect![[r#"
            error: `]` is missing here
              --> model.toml:44:26
               |
            44 | vector = ["-c*v(P) @ N [1", 0, 0]
               |                          ^
               |
               = help: write v(POINT) @ FRAME [1], v(BODY, POINT) @ FRAME [1] for the material of a body, omega(BODY) @ FRAME [1], or p(POINT) @ FRAME [1] for a position"#]],
    );
}

#[test]
fn a_particle_has_no_material_elsewhere() {
    check(
        "\"-c*v(cart, C) @ N [1]\"",
        &expect![[r#"
        error: the particle `cart` is not at the point `C`
          --> model.toml:44:23
           |
        44 | vector = ["-c*v(cart, C) @ N [1]", 0, 0]
           |                       ^
           |
           = help: write v(C): a particle has no material elsewhere"#]],
    );
}

#[test]
fn a_velocity_has_its_unit() {
    check(
        "\"v(P) @ N [1]\"",
        &expect![[r#"
        error: the vector of force `damper` must be in N, but `v(P) @ N [1]` is in m/s
          --> model.toml:44:12
           |
        44 | vector = ["v(P) @ N [1]", 0, 0]
           |            ^^^^^^^^^^^^
           |
           = help: check the units of the parameters and coordinates"#]],
    );
    check(
        "\"-c*(v(P) @ N [1] + x)\"",
        &expect![[r#"
        error: `x` is in m but `v(P) @ N [1]` in m/s: they cannot be added
          --> model.toml:44:12
           |
        44 | vector = ["-c*(v(P) @ N [1] + x)", 0, 0]
           |            ^^^^^^^^^^^^^^^^^^^^^
           |
           = help: check the units of the parameters and coordinates"#]],
    );
}

#[test]
fn a_load_does_not_divide_by_what_stands_still() {
    check(
        "\"c*(v(P) @ N [1])^2/v(P) @ N [2]\"",
        &expect![[r"
        error: the load `damper` divides by a term that is always zero, in c*v(P) @ N [1]^2/v(P) @ N [2]
          --> model.toml:41:9
           |
        41 | [forces.damper]
           |         ^^^^^^
           |
           = help: divide by what can differ from zero, such as the speed of a point that moves"]],
    );
    check(
        "\"c*(v(P) @ N [1])^2/(v(P) @ N [1] - x')\"",
        &expect![[r"
        error: the load `damper` divides by a term that is always zero, in c*v(P) @ N [1]^2/(x' - v(P) @ N [1])
          --> model.toml:41:9
           |
        41 | [forces.damper]
           |         ^^^^^^
           |
           = help: divide by what can differ from zero, such as the speed of a point that moves"]],
    );
}

/// Goal: a speed that is a velocity is the speed that its formula defines. Method: both ways to state it.
#[test]
fn a_speed_may_be_a_velocity_of_a_point_or_a_frame() {
    let stated = [("\"x'\"", "\"v(P) @ N [1]\""), ("\"q'\"", "\"omega(rod) @ A [3]\"")];
    let (by_velocities, by_rates) = (read(&edited(&stated, "")).unwrap(), read(BASE).unwrap());
    let shown = |model: &Model| -> Vec<String> {
        model.speeds.iter().map(|speed| print_text(&model.arena, speed.definition)).collect()
    };
    assert_eq!(shown(&by_velocities), shown(&by_rates));
    let units = |model: &Model| -> Vec<String> { model.speeds.iter().map(|speed| speed.unit.to_string()).collect() };
    assert_eq!(units(&by_velocities), units(&by_rates));
}

#[test]
fn a_speed_of_an_unknown_point_has_its_place() {
    let text = edited(&[("\"x'\"", "\"v(R) @ N [1]\"")], "");
    let said = errors(&text).to_string();
    assert!(said.contains("there is no point `R`") && said.contains("model.toml:14:9"), "{said}");
}
