//! Frames turned about any axis and by Euler parameters.
//!
//! Truth: permutations of axes, turns about one axis, and that cosines are those of a rotation.

use crate::common;

use common::{errors, read};
use expect_test::{Expect, expect};
use tripos_derive::algebra::meaning::compare::Comparer;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::{Model, Turn, TurnSense};
use tripos_derive::prove::prove;

const WORLD: &str = "name = \"turns\"\n[parameters]\na = \"2 m\"\nb = { unit = \"1\", value = 0.3 }\nm = \"1 kg\"\nI = { unit = \"kg*m^2\", \
                     value = 1, positive = true }\n[coordinates]\nq = { unit = \"rad\" }\n[speeds]\nu = \"q'\"\n[inertial]\nframe = \
                     \"N\"\norigin = \"O\"\n";
const BODY: &str = "[bodies]\nbody = { frame = \"B\", centre = \"O\", mass = \"m\", inertia = { diagonal = [\"I\", \"2*I\", \"2*I\"] } }\n";

fn turned(how: &str) -> Model {
    read(&format!("{WORLD}[frames]\nB = {{ from = \"N\", {how} }}\n{BODY}")).unwrap_or_else(|e| panic!("{e}"))
}

/// The cosines of B in N.
fn cosines(model: &Model, arena: &mut Arena) -> [[Expr; 3]; 3] {
    let mut frames = tripos_derive::geometry::Frames::new(&model.frames);
    let of = model.frames.iter().position(|f| f.name == "B").unwrap();
    frames.rotation(arena, 0, of)
}

fn is_equal(arena: &mut Arena, a: Expr, b: Expr) -> bool {
    Comparer::default().compare(arena, a, b).is_equal()
}

/// A third of a turn about the diagonal of a cube permutes its axes; a turn about a reversed axis is one by the
/// opposite angle.
#[test]
fn vectors_are_axes() {
    let model = turned("axis = [1, 1, 1], angle = \"2*pi/3 + 0*q\"");
    let arena = &mut model.arena.clone();
    let found = cosines(&model, arena);
    for (i, row) in found.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            // b1 = n2, b2 = n3, b3 = n1.
            let truth = if j == (i + 1) % 3 { Expr::ONE } else { Expr::ZERO };
            assert!(is_equal(arena, *entry, truth), "{i} {j}");
        }
    }
    for (axis, vector) in [(0, "[\"b\", 0, 0]"), (1, "[0, 3, 0]"), (2, "[0, 0, 0.5]")] {
        for sign in ["", "-"] {
            let vector = vector.replace("\"b\"", "2");
            let vector =
                if sign == "-" { vector.replace('2', "-2").replace('3', "-3").replace("0.5", "-0.5") } else { vector };
            let one = turned(&format!("axis = {vector}, angle = \"q\""));
            let other = turned(&format!("axis = {}, angle = \"{sign}q\"", axis + 1));
            let arena = &mut one.arena.clone();
            let (found, q) = (cosines(&one, arena), one.coordinates[0].symbol);
            let angle = if sign == "-" { arena.neg(q) } else { q };
            let turn = Turn::About(axis, angle);
            assert!(matches!(other.frames[1].rotation, Some((0, Turn::About(at, _))) if at == axis));
            for column in 0..3 {
                let mut unit = [Expr::ZERO; 3];
                unit[column] = Expr::ONE;
                let truth = turn.apply(arena, &unit, TurnSense::Forward);
                for row in 0..3 {
                    assert!(is_equal(arena, found[row][column], truth[row]), "{vector} {row} {column}");
                }
            }
        }
    }
}

/// Goal: any four numbers give a rotation. Method: for Euler parameters of any length, and for a turn about any vector
/// of parameters, the rows of the cosines have length 1 and are at right angles; the axis stays where it is.
#[test]
fn cosines_are_of_rotations() {
    let free = "euler_parameters = [\"e0\", \"e1\", \"e2\", \"e3\"]";
    let names: Vec<String> = (0..4).map(|i| format!("e{i} = {{ unit = \"1\" }}\n")).collect();
    let text = format!("{WORLD}[frames]\nB = {{ from = \"N\", {free} }}\n{BODY}")
        .replace("q = { unit = \"rad\" }\n", &names.concat())
        .replace("u = \"q'\"\n", "u1 = \"e1'\"\nu2 = \"e2'\"\nu3 = \"e3'\"\n");
    let by_parameters = read(&text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(by_parameters.loops.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(), ["B_norm"]);
    let by_vector = turned("axis = [\"b\", \"-sqrt(b)\", \"1 - b\"], angle = \"q\"");
    for model in [&by_parameters, &by_vector] {
        let arena = &mut model.arena.clone();
        let rows = cosines(model, arena);
        for i in 0..3 {
            for j in 0..3 {
                let products: Vec<Expr> = (0..3).map(|k| arena.mul(rows[i][k], rows[j][k])).collect();
                let sum = arena.sum(&products);
                assert!(is_equal(arena, sum, if i == j { Expr::ONE } else { Expr::ZERO }), "{i} {j}");
            }
        }
        let mut derivations = derive_all(model).unwrap();
        let proof = prove(model, &mut derivations);
        assert_eq!(proof.pairs.len(), 3);
        assert!(proof.pairs.iter().all(|e| e.verdict.is_equal()), "{:?}", proof.pairs);
    }
}

fn check(how: &str, expected: &Expect) {
    let text = format!("{WORLD}[frames]\nB = {{ from = \"N\", {how} }}\n{BODY}");
    let lines: Vec<String> = errors(&text).to_string().lines().map(|l| l.trim_end().to_owned()).collect();
    expected.assert_eq(&lines.join("\n"));
}

#[test]
fn turns_that_cannot_be() {
    check(
        "axis = [0, \"b - b\", 0], angle = \"q\"",
        &expect![[r#"
        error: the axis of frame `B` has no direction
          --> model.toml:15:26
           |
        15 | B = { from = "N", axis = [0, "b - b", 0], angle = "q" }
           |                          ^^^^^^^^^^^^^^^
           |
           = help: write axis = [1, 0, 1], or axis = 3"#]],
    );
    check(
        "axis = [1, 2], angle = \"q\"",
        &expect![[r#"
        error: the axis of frame `B` must be an array of 3
          --> model.toml:15:26
           |
        15 | B = { from = "N", axis = [1, 2], angle = "q" }
           |                          ^^^^^^
           |
           = help: write one formula for each"#]],
    );
    check(
        "axis = [1, 2, \"a\"], angle = \"q\"",
        &expect![[r#"
        error: the axis of frame `B` must be in 1 or rad, but `a` is in m
          --> model.toml:15:34
           |
        15 | B = { from = "N", axis = [1, 2, "a"], angle = "q" }
           |                                  ^
           |
           = help: check the units of the parameters and coordinates"#]],
    );
    check(
        "axis = [1, 2, \"q\"], angle = \"q\"",
        &expect![[r#"
        error: the coordinate `q` cannot stand in the axis of frame `B`
          --> model.toml:15:34
           |
        15 | B = { from = "N", axis = [1, 2, "q"], angle = "q" }
           |                                  ^
           |
           = help: allowed: parameters"#]],
    );
    check(
        "euler_parameters = [\"q\", 0, 0], angle = \"q\"",
        &expect![[r#"
        error: `euler_parameters` must be an array of 4
          --> model.toml:15:38
           |
        15 | B = { from = "N", euler_parameters = ["q", 0, 0], angle = "q" }
           |                                      ^^^^^^^^^^^
           |
           = help: write one formula for each

        error: unknown key `angle` in a frame
          --> model.toml:15:51
           |
        15 | B = { from = "N", euler_parameters = ["q", 0, 0], angle = "q" }
           |                                                   ^^^^^
           |
           = help: known here: `euler_parameters`, `from`, `about`"#]],
    );
    check(
        "euler_parameters = [0, 0, 0, 0]",
        &expect![[r#"
        error: `euler_parameters` are all 0
          --> model.toml:15:38
           |
        15 | B = { from = "N", euler_parameters = [0, 0, 0, 0] }
           |                                      ^^^^^^^^^^^^
           |
           = help: name four coordinates, the scalar first"#]],
    );
}
