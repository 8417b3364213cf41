//! Equations in moving frames: which mechanisms have them, and which keep their states.

use crate::reduced;

use expect_test::expect;
use reduced::{integrated, ledger, library, reduced, show};

/// A mass in the plane that a potential of its distance attracts.
const CENTRAL: &str = r#"
    name = "Central force"
    [parameters]
    m = { unit = "kg", value = 1.5, positive = true }
    k = { unit = "N*m^2", value = 2.3, positive = true }
    [coordinates]
    x = { unit = "m" }
    y = { unit = "m" }
    [speeds]
    vx = "x'"
    vy = "y'"
    [inertial]
    frame = "N"
    origin = "O"
    [points]
    P = { from = "O", frame = "N", position = ["x", "y", 0] }
    [particles]
    planet = { point = "P", mass = "m" }
    [potentials]
    sun = "-k/sqrt(x^2 + y^2)"
"#;

/// Two masses in space that attract one another.
pub const TWO_BODIES: &str = r#"
    name = "Two bodies"
    [parameters]
    m = { unit = "kg", value = 1.5, positive = true }
    M = { unit = "kg", value = 4, positive = true }
    k = { unit = "N*m^2", value = 2.3, positive = true }
    [coordinates]
    x = { unit = "m" }
    y = { unit = "m" }
    z = { unit = "m" }
    X = { unit = "m" }
    Y = { unit = "m" }
    Z = { unit = "m" }
    [speeds]
    vx = "x'"
    vy = "y'"
    vz = "z'"
    VX = "X'"
    VY = "Y'"
    VZ = "Z'"
    [inertial]
    frame = "N"
    origin = "O"
    [points]
    A = { from = "O", frame = "N", position = ["x", "y", "z"] }
    B = { from = "O", frame = "N", position = ["X", "Y", "Z"] }
    [particles]
    a = { point = "A", mass = "m" }
    b = { point = "B", mass = "M" }
    [potentials]
    sun = "-k/distance(A, B)"
"#;

#[test]
fn a_central_force_keeps_the_distance_and_its_rate() {
    let r = reduced(CENTRAL, "outputs = [{ name = \"r\", value = \"sqrt(x^2 + y^2)\" }]\nfree = [\"m\", \"k\"]");
    expect![[r""]].assert_eq(&(show(&r) + &ledger(&r)));
}

#[test]
fn a_direction_that_is_shown_keeps_its_states() {
    let r = reduced(CENTRAL, "outputs = [\"x\", \"y\"]");
    assert_eq!((integrated(&r).0.len(), r.frame.is_none()), (4, true));
}

/// Of what is not the same in all directions, nothing is turned.
#[test]
fn what_has_no_symmetry_keeps_its_states() {
    let uneven = CENTRAL.replace("x^2 + y^2", "x^2 + 2*y^2");
    let r = reduced(&uneven, "outputs = [{ name = \"r\", value = \"sqrt(x^2 + y^2)\" }]");
    assert_eq!((integrated(&r).0.len(), r.frame.is_none()), (4, true));
}

#[test]
fn two_bodies_keep_their_distance_and_its_rate() {
    let r = reduced(TWO_BODIES, "outputs = [{ name = \"d\", value = \"distance(A, B)\" }]\nfree = [\"m\", \"M\", \"k\"]");
    expect![[r""]].assert_eq(&(show(&r) + &ledger(&r)));
}

/// Cardan's angles of a symmetric top turn together about the vertical, and none alone.
#[test]
fn a_top_in_cardans_angles_has_one_degree_of_freedom() {
    let r = top("outputs = [{ name = \"height\", value = \"cos(q1)*cos(q2)\" }]");
    expect![[r""]].assert_eq(&(show(&r) + &ledger(&r)));
}

/// The domain of the library's top names an angle that its frame would turn.
#[test]
fn a_domain_that_names_what_turns_keeps_it() {
    let r = library("heavy_top", "looping", "[{ name = \"height\", value = \"cos(q1)*cos(q2)\" }]");
    assert!(r.frame.is_none());
}

/// The reduction of the library's top without its domain.
fn top(scene: &str) -> tripos_derive::reduce::Reduction {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/heavy_top/model.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let (text, _) = text.split_once("[domain]").unwrap();
    reduced(text, scene)
}
