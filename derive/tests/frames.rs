//! Equations in moving frames: mechanisms that have such a frame, and mechanisms that keep their states.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

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
    expect![[r"
        states: x, vx
        H_n3 [kg*m^2/s] = m*x*vy
        k_per_m [m^3/s^2] = k/m
        vy = H_n3/(m*x)
        x' = vx
        vx' = (vy^2 - k_per_m*sqrt(x^2)/x^2)/x
        r -> sqrt(x^2)
        energy known; divided by: x
        vy | vy = H_n3/(m*x), from what is constant: angular momentum about n3 through O | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-63)
        y | zero in a frame that moves by a rotation about n3 through O, which changes nothing that is shown | each commutes with the motion of the whole model and leaves what is shown and watched, by identity (in doubt by less than 2^-63)
    "]].assert_eq(&(show(&r) + &ledger(&r)));
}

#[test]
fn a_direction_that_is_shown_keeps_its_states() {
    let r = reduced(CENTRAL, "outputs = [\"x\", \"y\"]");
    assert_eq!((integrated(&r).0.len(), r.frame.is_none()), (4, true));
}

/// A potential that is not the same in all directions has no frame that turns.
#[test]
fn what_has_no_symmetry_keeps_its_states() {
    let uneven = CENTRAL.replace("x^2 + y^2", "x^2 + 2*y^2");
    let r = reduced(&uneven, "outputs = [{ name = \"r\", value = \"sqrt(x^2 + y^2)\" }]");
    assert_eq!((integrated(&r).0.len(), r.frame.is_none()), (4, true));
}

#[test]
fn two_bodies_keep_their_distance_and_its_rate() {
    let r =
        reduced(TWO_BODIES, "outputs = [{ name = \"d\", value = \"distance(A, B)\" }]\nfree = [\"m\", \"M\", \"k\"]");
    expect![[r"
        states: Y_from_y, VY_from_vy
        P_n3 [kg*m/s] = m*vz + M*VZ
        H_n1_scaled [kg*m^2/s] = m*M*(Y - y)*(vz - VZ)/(m + M)
        H_n1_scaled_per_m [1] = M*(Y - y)*(vz - VZ)/(m + M)
        k_per_m_per_M [m^3/kg/s^2] = k/(m*M)
        vz = P_n3/(m + M) + H_n1_scaled_per_m/Y_from_y
        VZ_from_vz = (P_n3 - vz*(m + M))/M
        Y_from_y' = VY_from_vy
        VY_from_vy' = (VZ_from_vz^2 - k_per_m_per_M*sqrt(Y_from_y^2)*(m + M)/Y_from_y^2)/Y_from_y
        d -> sqrt(Y_from_y^2)
        energy known; divided by: Y_from_y
        VZ_from_vz | VZ_from_vz = (P_n3 - vz*(m + M))/M, from what is constant: linear momentum along n3 | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-63)
        vx | no output and nothing that outputs need depends on vx | no formula that is left mentions it
        vy | no output and nothing that outputs need depends on vy | no formula that is left mentions it
        vz | vz = P_n3/(m + M) + H_n1_scaled/(m*Y_from_y), from what is constant: linear momentum along n3; -1 times the angular momentum about n1 through the mass centre | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-63)
        X_from_x, Z_from_z, VX_from_vx | zero in a frame that moves by a rotation about n1 through the mass centre and by a rotation about n2 through the mass centre and by a rotation about n3 through the mass centre, which changes nothing that is shown | each commutes with the motion of the whole model and leaves what is shown and watched, by identity (in doubt by less than 2^-63)
        X | X_from_x stands for it | an identity shows that a symmetry moves X and x together
        VX | VX_from_vx stands for it | an identity shows that a symmetry moves VX and vx together
        Y | Y_from_y stands for it | an identity shows that a symmetry moves Y and y together
        VY | VY_from_vy stands for it | an identity shows that a symmetry moves VY and vy together
        Z | Z_from_z stands for it | an identity shows that a symmetry moves Z and z together
        VZ | VZ_from_vz stands for it | an identity shows that a symmetry moves VZ and vz together
        x | no output and nothing that outputs need depends on x | no formula that is left mentions it
        y | no output and nothing that outputs need depends on y | no formula that is left mentions it
        z | no output and nothing that outputs need depends on z | no formula that is left mentions it
    "]].assert_eq(&(show(&r) + &ledger(&r)));
}

/// Cardan's angles of a symmetric top turn together about the vertical, and none alone.
#[test]
fn a_top_in_cardans_angles_has_one_degree_of_freedom() {
    let r = top("outputs = [{ name = \"height\", value = \"cos(q1)*cos(q2)\" }]");
    expect![[r"
        states: q1, u1
        p_q3 [kg*m^2/s] = I3*u3
        H_n3 [kg*m^2/s] = I1*u2*sin(q1) + I3*u3*cos(q1)
        m_l_g [kg*m^2/s^2] = m*l*g
        u2 = (H_n3 - p_q3*cos(q1))/(I1*sin(q1))
        u3 = p_q3/I3
        q1' = u1
        u1' = (m_l_g*sin(q1) - u2*(I3*u3 - I1*u2/tan(q1)))/I1
        height -> cos(q1)
        energy known; divided by: sin(q1)
        u3 | u3 = p_q3/I3, from what is constant: momentum p_q3 = ∂L/∂q3' | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-98)
        u2 | u2 = (H_n3 - p_q3*cos(q1))/(I1*sin(q1)), from what is constant: momentum p_q3 = ∂L/∂q3'; angular momentum about n3 through O | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-98)
        q2 | zero in a frame that moves by a rotation about n3 through O, which changes nothing that is shown | each commutes with the motion of the whole model and leaves what is shown and watched, by identity (in doubt by less than 2^-98)
        q3 | no output and nothing that outputs need depends on q3 | no formula that is left mentions it
        hold1, hold2, hold3 | no output or event asks for it | reactions enter no equation of motion
    "]].assert_eq(&(show(&r) + &ledger(&r)));
}

/// The domain of the library's top depends on an angle that its frame would turn.
#[test]
fn a_domain_that_names_what_turns_keeps_it() {
    let r = library("heavy_top", "looping", "[{ name = \"height\", value = \"cos(q1)*cos(q2)\" }]");
    assert!(r.frame.is_none());
    assert_eq!(r.kept_by_domain, ["a rotation about n3 through O"]);
}

/// The reduction of the library's top without its domain.
fn top(scene: &str) -> tripos_derive::reduce::Reduction {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/heavy_top/model.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let (text, _) = text.split_once("[domain]").unwrap();
    reduced(text, scene)
}
