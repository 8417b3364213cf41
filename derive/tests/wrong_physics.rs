//! Messages for wrong models, word for word: speeds, units, masses, constraints, loads.
//!
//! `UPDATE_EXPECT=1 cargo test` accepts new words; read them before you commit them.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::common;

use common::{edited, errors};
use expect_test::{Expect, expect};

fn check(text: &str, expected: &Expect) {
    let lines: Vec<String> = errors(text).to_string().lines().map(|l| l.trim_end().to_owned()).collect();
    expected.assert_eq(&lines.join("\n"));
}

#[test]
fn dependent_speeds_name_the_one_that_follows() {
    check(
        &edited(&[("\"q'\"", "\"2*x'\"")], ""),
        &expect![[r#"
        error: the speeds are not independent: rank 1 of 2; `u2` follows from the others
          --> model.toml:15:7
           |
        15 | u2 = "2*x'"
           |       ^^^^
           |
           = help: the speeds must determine every q' uniquely"#]],
    );
}

#[test]
fn a_quadratic_speed_shows_its_coefficient() {
    check(
        &edited(&[("\"q'\"", "\"q'^2\"")], ""),
        &expect![[r#"
        error: speed `u2` is not linear in the time derivatives x', q': its coefficient of q' is 2*q'
          --> model.toml:15:7
           |
        15 | u2 = "q'^2"
           |       ^^^^
           |
           = help: a generalized speed must read  u = Σ c_i(q) q_i' + d(q)"#]],
    );
}

#[test]
fn an_absolute_value_is_not_linear() {
    check(
        &edited(&[("\"q'\"", "\"q' + abs(q')\"")], ""),
        &expect![[r#"
        error: speed `u2` is not linear in the time derivatives x', q': its coefficient of q' is 1 + sign(q')
          --> model.toml:15:7
           |
        15 | u2 = "q' + abs(q')"
           |       ^^^^^^^^^^^^
           |
           = help: a generalized speed must read  u = Σ c_i(q) q_i' + d(q)"#]],
    );
}

#[test]
fn too_few_speeds_point_at_the_section() {
    check(
        &edited(&[("u2 = \"q'\"\n", "")], ""),
        &expect![[r"
            error: 1 speed for 2 generalized coordinates: the numbers must agree
              --> model.toml:13:2
               |
            13 | [speeds]
               |  ^^^^^^
               |
               = help: define one speed for each coordinate that no constraint fixes (x, q); constraints on velocities, each of which takes a speed away, stand under [constraints] and [rolling]"]],
    );
}

#[test]
fn too_many_speeds_point_at_the_first_surplus_one() {
    check(
        &edited(&[("u2 = \"q'\"", "u2 = \"q'\"\nu3 = \"q' + x'/length\"")], ""),
        &expect![[r#"
            error: 3 speeds for 2 generalized coordinates: the numbers must agree
              --> model.toml:16:1
               |
            16 | u3 = "q' + x'/length"
               | ^^
               |
               = help: define one speed for each coordinate that no constraint fixes (x, q); constraints on velocities, each of which takes a speed away, stand under [constraints] and [rolling]"#]],
    );
}

#[test]
fn a_broken_speed_is_one_error() {
    check(
        &edited(&[("\"q'\"", "\"q' +\"")], ""),
        &expect![[r#"
        error: the expression ends too early
          --> model.toml:15:11
           |
        15 | u2 = "q' +"
           |           ^
           |
           = help: an operand is missing here"#]],
    );
}

#[test]
fn a_unit_that_does_not_fit_is_refused() {
    check(
        &edited(
            &[("m/s^2", "m/s"), ("angle = \"q\"", "angle = \"x\""), ("-length", "-length + q")],
            "[torques.motor]\non = \"rod\"\nframe = \"N\"\nvector = [0, 0, \"m*g\"]\n",
        ),
        &expect![[r#"
            error: an angle must be in 1 or rad, but `x` is in m
              --> model.toml:22:38
               |
            22 | A = { from = "N", axis = 3, angle = "x" }
               |                                      ^
               |
               = help: check the units of the parameters and coordinates

            error: `length` is in m but `q` in 1 or rad: they cannot be added
              --> model.toml:26:48
               |
            26 | C = { from = "P", frame = "A", position = [0, "-length + q", 0] }
               |                                                ^^^^^^^^^^^
               |
               = help: check the units of the parameters and coordinates

            error: the acceleration of `gravity` must be in m/s^2, but `-g` is in m/s
              --> model.toml:39:21
               |
            39 | acceleration = [0, "-g", 0]
               |                     ^^
               |
               = help: check the units of the parameters and coordinates

            error: the vector of torque `motor` must be in N*m, but `m*g` is in kg*m/s
              --> model.toml:43:18
               |
            43 | vector = [0, 0, "m*g"]
               |                  ^^^
               |
               = help: check the units of the parameters and coordinates"#]],
    );
}

#[test]
fn a_plain_number_has_no_unit() {
    check(
        &edited(&[("\"-length\"", "-0.5")], ""),
        &expect![[r#"
            error: the position of point `C` must be in m, but `-0.5` is in 1 or rad
              --> model.toml:26:47
               |
            26 | C = { from = "P", frame = "A", position = [0, -0.5, 0] }
               |                                               ^^^^
               |
               = help: a bare number has no unit: declare a parameter such as `x0 = { unit = "m", value = 0.1 }` and use its name"#]],
    );
}

#[test]
fn a_negative_mass_is_refused() {
    check(
        &edited(&[("value = 2, positive = true", "value = -2")], ""),
        &expect![[r#"
        error: the mass of `cart` is -2 at the default values
          --> model.toml:29:1
           |
        29 | cart = { point = "P", mass = "m" }
           | ^^^^
           |
           = help: give a mass that is not negative

        error: the mass of `rod` is -2 at the default values
          --> model.toml:31:9
           |
        31 | [bodies.rod]
           |         ^^^
           |
           = help: give a mass that is not negative"#]],
    );
}

#[test]
fn an_impossible_inertia_is_refused() {
    check(
        &edited(&[("[\"I\", 0, \"I\"]", "[\"I\", \"I\", \"3*I\"]")], ""),
        &expect![[r"
        error: no body has the central inertia of `rod`: moments 0.1, 0.1, 0.3 break the triangle inequality
          --> model.toml:31:9
           |
        31 | [bodies.rod]
           |         ^^^
           |
           = help: each principal moment is at most the sum of the other two (equal for a thin plate)"]],
    );
}

#[test]
fn an_inertia_about_the_hinge_smaller_than_m_d_squared_is_refused() {
    check(
        &edited(&[("[\"I\", 0, \"I\"]", "[\"I\", 0, \"I\"], about_point = \"P\"")], ""),
        &expect![[r"
        error: the central moments of inertia of `rod` are -0.4, 0, -0.4
          --> model.toml:31:9
           |
        31 | [bodies.rod]
           |         ^^^
           |
           = help: a moment of inertia cannot be negative; about a point at distance d from the mass centre it is at least m d^2"]],
    );
}

#[test]
fn a_coordinate_that_moves_no_mass_is_named() {
    check(
        &edited(&[("mass = \"m\"", "mass = 0"), ("mass = \"m\"", "mass = 0")], ""),
        &expect![[r#"
            error: the speed `u1` moves no mass: the mass matrix is singular in every configuration
              --> model.toml:14:1
               |
            14 | u1 = "x'"
               | ^^
               |
               = help: give a mass to the bodies that move with the coordinate, or leave the coordinate out"#]],
    );
}

#[test]
fn a_constraint_that_is_always_or_never_fulfilled_is_refused() {
    check(
        &edited(
            &[],
            "[constraints]\na = { equation = \"x - x = 0\" }\nb = { equation = \"1 = 0\" }\nc = { equation = \"x^2 = length^2\" }\n",
        ),
        &expect![[r#"
            error: the constraint `a` is always fulfilled
              --> model.toml:41:19
               |
            41 | a = { equation = "x - x = 0" }
               |                   ^^^^^^^^^
               |
               = help: remove it, or state a relation that restricts the coordinates

            error: the constraint `b` is never fulfilled
              --> model.toml:42:19
               |
            42 | b = { equation = "1 = 0" }
               |                   ^^^^^
               |
               = help: a holonomic constraint is an equation between coordinates"#]],
    );
}

#[test]
fn a_reaction_that_works_is_refused() {
    check(
        &edited(&[], "[reactions.rail]\non = \"cart\"\nframe = \"N\"\ndirection = [1, 0, 0]\n"),
        &expect![[r"
        error: the reaction `rail` does work along `x`: power 1 for each unit of x'
          --> model.toml:40:12
           |
        40 | [reactions.rail]
           |            ^^^^
           |
           = help: a reaction acts at the constraint and along the forbidden motion; a force that does work is an applied force"]],
    );
}

#[test]
fn a_torque_on_a_particle_is_refused() {
    check(
        &edited(&[], "[torques.motor]\non = \"cart\"\nframe = \"N\"\nvector = [0, 0, \"m*g*length\"]\n"),
        &expect![[r#"
            error: the body `cart` is a particle: no torque can act on a particle
              --> model.toml:41:7
               |
            41 | on = "cart"
               |       ^^^^
               |
               = help: name a rigid body or a frame"#]],
    );
}
