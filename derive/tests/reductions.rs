//! The reduced systems of the library as people read them: the least that the outputs need, and nothing of what they do not.

#[path = "common/reduced.rs"]
mod reduced;

use expect_test::{Expect, expect};
use reduced::{integrated, ledger, library, show};

#[allow(clippy::needless_pass_by_value, reason = "as expect! is used everywhere")]
fn check(model: &str, scene: &str, outputs: &str, expected: Expect) {
    expected.assert_eq(&show(&library(model, scene, outputs)));
}

#[test]
fn disk_lean() {
    check(
        "disk",
        "report-10s",
        r#"["q2", "u1"]"#,
        expect![[r"
            states: q2_minus_90deg, u1
            p_q3 [kg*m^2/s] = u3/2
            H_a3_there [kg*m^2/s] = u2*cos(q2)/4 + u3*(sin(q2) - 1)/2
            u2 = -4*(2*p_q3*sin(q2_minus_90deg/2)^2 + H_a3_there)/sin(q2_minus_90deg)
            u3 = 2*p_q3
            q2_minus_90deg' = -u1
            (5/4 - sin(q2_minus_90deg)^2)*u1' = -u2*u3/2 - cos(q2_minus_90deg)*(981 + 100*u1^2*sin(q2_minus_90deg) + 25*u2^2/sin(q2_minus_90deg))/100
            q2 -> pi/2 + q2_minus_90deg
            upright while pi/2 - abs(pi/2 + q2_minus_90deg) > 0
            contact while (100*u1^2 + 981*sin(q2_minus_90deg) - 100*cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + u2*(2*u3*sin(q2_minus_90deg) + u2*cos(q2_minus_90deg))))/(100*sin(q2_minus_90deg)*(1 + 4*cos(q2_minus_90deg)^2)) > 0
            energy known; divided by: -sin(q2_minus_90deg); -sin(q2_minus_90deg)/4
        "]],
    );
}

#[test]
fn disk_with_ten_outputs() {
    check(
        "disk",
        "report-10s",
        "",
        expect![[r"
            states: q2_minus_90deg, u1
            quadratures: q3, q1
            p_q3 [kg*m^2/s] = u3/2
            p_q4 [kg*m/s] = u1*sin(q1)*cos(q2) - u2*cos(q1)*tan(q2) + u4
            p_q5 [kg*m/s] = u5 - u1*cos(q1)*cos(q2) - u2*sin(q1)*tan(q2)
            H_a3_there [kg*m^2/s] = u2*cos(q2)/4 + u3*(sin(q2) - 1)/2
            centre_q4 [kg*m] = q4 - sin(q1)*sin(q2)
            centre_q5 [kg*m] = cos(q1)*sin(q2) + q5
            u2 = -4*(2*p_q3*sin(q2_minus_90deg/2)^2 + H_a3_there)/sin(q2_minus_90deg)
            u5 = p_q5 - u1*cos(q1)*sin(q2_minus_90deg) - u2*sin(q1)/tan(q2_minus_90deg)
            u4 = u1*sin(q1)*sin(q2_minus_90deg) - u2*cos(q1)/tan(q2_minus_90deg) + p_q4
            u3 = 2*p_q3
            q2_minus_90deg' = -u1
            q3' = u3 + u2/tan(q2_minus_90deg)
            q1' = -u2/sin(q2_minus_90deg)
            (5/4 - sin(q2_minus_90deg)^2)*u1' = -u2*u3/2 - cos(q2_minus_90deg)*(981 + 100*u1^2*sin(q2_minus_90deg) + 25*u2^2/sin(q2_minus_90deg))/100
            q2 -> pi/2 + q2_minus_90deg
            q4 -> sin(q1)*cos(q2_minus_90deg) + p_q4*t + centre_q4
            q5 -> p_q5*t - cos(q1)*cos(q2_minus_90deg) + centre_q5
            upright while pi/2 - abs(pi/2 + q2_minus_90deg) > 0
            contact while (100*u1^2 + 981*sin(q2_minus_90deg) - 100*cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + u2*(2*u3*sin(q2_minus_90deg) + u2*cos(q2_minus_90deg))))/(100*sin(q2_minus_90deg)*(1 + 4*cos(q2_minus_90deg)^2)) > 0
            energy known; divided by: -sin(q2_minus_90deg); -sin(q2_minus_90deg)/4
        "]],
    );
}

#[test]
fn disk_contact_force_and_accelerations() {
    check(
        "disk",
        "report-10s",
        r#"["N", "u1'", "q1'"]"#,
        expect![[r"
            states: q2_minus_90deg, u1
            p_q3 [kg*m^2/s] = u3/2
            H_a3_there [kg*m^2/s] = u2*cos(q2)/4 + u3*(sin(q2) - 1)/2
            u2 = -4*(2*p_q3*sin(q2_minus_90deg/2)^2 + H_a3_there)/sin(q2_minus_90deg)
            u3 = 2*p_q3
            q2_minus_90deg' = -u1
            (5/4 - sin(q2_minus_90deg)^2)*u1' = -u2*u3/2 - cos(q2_minus_90deg)*(981 + 100*u1^2*sin(q2_minus_90deg) + 25*u2^2/sin(q2_minus_90deg))/100
            N -> (100*u1^2 + 981*sin(q2_minus_90deg) - 100*cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + u2*(2*u3*sin(q2_minus_90deg) + u2*cos(q2_minus_90deg))))/(100*sin(q2_minus_90deg)*(1 + 4*cos(q2_minus_90deg)^2))
            u1' -> (50*u2*u3 + cos(q2_minus_90deg)*(981 + 100*u1^2*sin(q2_minus_90deg) + 25*u2^2/sin(q2_minus_90deg)))/(25*(4*sin(q2_minus_90deg)^2 - 5))
            q1' -> -u2/sin(q2_minus_90deg)
            upright while pi/2 - abs(pi/2 + q2_minus_90deg) > 0
            contact while (100*u1^2 + 981*sin(q2_minus_90deg) - 100*cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + u2*(2*u3*sin(q2_minus_90deg) + u2*cos(q2_minus_90deg))))/(100*sin(q2_minus_90deg)*(1 + 4*cos(q2_minus_90deg)^2)) > 0
            energy known; divided by: -sin(q2_minus_90deg); -sin(q2_minus_90deg)/4
        "]],
    );
}

#[test]
fn top_in_eulers_angles() {
    check(
        "euler_top",
        "looping",
        "",
        expect![[r"
            states: theta, u1
            quadratures: phi, psi
            p_psi_there [kg*m^2/s] = 19*u2*sin(theta)/200 + 21*u3*(cos(theta) - 1)/1000
            p_phi [kg*m^2/s] = 21*u3/1000
            u2 = 200*(2*p_phi*sin(theta/2)^2 + p_psi_there)/(19*sin(theta))
            u3 = 1000*p_phi/21
            theta' = u1
            phi' = u3 - u2/tan(theta)
            psi' = u2/sin(theta)
            (19/200)*u1' = 140283*sin(theta)/50000 + u2*(95*u2/tan(theta) - 21*u3)/1000
            regular while sin(theta) > 0
            energy known; divided by: sin(theta); 19*sin(theta)/200
        "]],
    );
}

#[test]
fn spherical_pendulum() {
    check(
        "spherical_pendulum",
        "wide",
        "",
        expect![[r"
            states: theta, u1
            quadratures: phi
            p_phi [kg*m^2/s] = u2*sin(theta)
            u2 = p_phi/sin(theta)
            theta' = u1
            phi' = u2/sin(theta)
            u1' = u2^2/tan(theta) - 981*sin(theta)/100
            regular while sin(theta) > 0
            energy known; divided by: sin(theta)
        "]],
    );
}

#[test]
fn free_body() {
    check(
        "free_body",
        "steady",
        "",
        expect![[r"
            states: theta, w1
            quadratures: phi, psi
            p_x [kg*m/s] = 2*v1
            p_y [kg*m/s] = 2*v2
            p_z [kg*m/s] = 2*v3
            p_psi_there [kg*m^2/s] = 3*w2*sin(theta)/10 + w3*(cos(theta) - 1)/2
            p_phi [kg*m^2/s] = w3/2
            centre_x [kg*m] = 2*x
            centre_y [kg*m] = 2*y
            centre_z [kg*m] = 2*z
            w2 = 10*(2*p_phi*sin(theta/2)^2 + p_psi_there)/(3*sin(theta))
            w3 = 2*p_phi
            v3 = p_z/2
            v2 = p_y/2
            v1 = p_x/2
            theta' = w1
            phi' = w3 - w2/tan(theta)
            psi' = w2/sin(theta)
            (3/10)*w1' = w2*(3*w2/tan(theta) - 5*w3)/10
            x -> p_x*t/2 + centre_x/2
            y -> p_y*t/2 + centre_y/2
            z -> p_z*t/2 + centre_z/2
            regular while sin(theta) > 0
            energy known; divided by: sin(theta); 3*sin(theta)/10
        "]],
    );
}

#[test]
fn floating_chain_folding_angle() {
    check(
        "floating_chain",
        "folding",
        r#"["theta2 - theta1", "x"]"#,
        expect![[r"
            states: theta2_from_theta1, theta3_from_theta1, u4_from_u3, u5_from_u3
            quadratures: theta1
            p_x [kg*m/s] = 21*u1/10 - 7*u3*sin(theta1)/25 - 21*u4*sin(theta2)/50 - 7*u5*sin(theta3)/50
            H_n3 [kg*m^2/s] = 7*u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3))/750 + 7*u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3)))/750 + 7*u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - …
            centre_x [kg*m] = 21*x/10 + 7*cos(theta1)/25 + 21*cos(theta2)/50 + 7*cos(theta3)/50
            u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*…
            theta2_from_theta1' = u4_from_u3
            theta3_from_theta1' = u5_from_u3
            theta1' = u3
            (7*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) - 18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta2_from_th…
            (7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 + 3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 - 3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_fr…
            theta2 - theta1 -> theta2_from_theta1
            x -> 10*p_x*t/21 - 2*cos(theta1)/15 - cos(theta1 + theta2_from_theta1)/5 - cos(theta1 + theta3_from_theta1)/15 + 10*centre_x/21
            energy known; divided by: 91/750 + 7*sin(theta2_from_theta1)*sin(theta3_from_theta1)/125 + 7*cos(theta3_from_theta1)/375 + 7*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))/125
        "]],
    );
}

#[test]
fn top_in_cardans_angles() {
    check(
        "heavy_top",
        "looping",
        "",
        expect![[r"
            states: q1, q2, u1, u2
            quadratures: q3
            p_q3 [kg*m^2/s] = 21*u3/1000
            u3 = 1000*p_q3/21
            q1' = u1/cos(q2)
            q2' = u2
            q3' = u3 - u1*tan(q2)
            (19/200)*u1' = 140283*sin(q1)/50000 + u2*(95*u1*tan(q2) - 21*u3)/1000
            (19/200)*u2' = 140283*cos(q1)*sin(q2)/50000 + u1*(21*u3 - 95*u1*tan(q2))/1000
            regular while pi/2 - abs(q2) > 0
            energy known; divided by: cos(q2)
        "]],
    );
}

#[test]
fn chaotic_pendulum_is_left_alone() {
    check(
        "chaotic_pendulum",
        "swing",
        "",
        expect![[r"
            states: theta, phi, omega, alpha
            theta' = omega
            phi' = alpha
            (687/500 + 3*cos(phi)^2/100)*omega' = 3*omega*alpha*sin(phi)*cos(phi)/50 - 163827*sin(theta)/10000
            (13/200)*alpha' = -3*omega^2*sin(phi)*cos(phi)/100
            energy known; divided by: nothing
        "]],
    );
}

/// Nothing is conserved but the energy; the cart's place and speed follow from the links, whose equations do not have them.
#[test]
fn links_do_not_depend_on_the_cart() {
    let r = library("cart_pendulum_3", "fall", "");
    assert_eq!(integrated(&r), (vec!["q1", "q2", "q3", "u1", "u2", "u3"], vec!["u0", "q0"]));
    let r = library("cart_pendulum_3", "fall", r#"["u0"]"#);
    assert_eq!(integrated(&r), (vec!["q1", "q2", "q3", "u1", "u2", "u3"], vec!["u0"]));
    assert!(!r.has_energy, "its potential has q0");
}

#[test]
fn the_ledger_of_the_lean_disk_says_what_is_left_out_and_why() {
    expect![[r"
        parameter M | the scene fixes it at 1 | the number of the scene file, put in exactly
        parameter R | the scene fixes it at 1 | the number of the scene file, put in exactly
        parameter g | the scene fixes it at 9.81 | the number of the scene file, put in exactly
        u3 | u3 = 2*p_q3, from what is constant: momentum p_q3 = ∂L/∂q3' | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-96)
        u4 | no output and nothing that outputs need depends on u4 | no formula that is left mentions it
        u5 | no output and nothing that outputs need depends on u5 | no formula that is left mentions it
        u2 | u2 = -4*(2*p_q3*sin(q2_minus_90deg/2)^2 + H_a3_there)/sin(q2_minus_90deg), from what is constant: momentum p_q3 = ∂L/∂q3'; angular momentum about a3 through the mass centre, what is left of it on the singular surface | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-96)
        q1 | no output and nothing that outputs need depends on q1 | no formula that is left mentions it
        q3 | no output and nothing that outputs need depends on q3 | no formula that is left mentions it
        q4 | no output and nothing that outputs need depends on q4 | no formula that is left mentions it
        q5 | no output and nothing that outputs need depends on q5 | no formula that is left mentions it
    "]].assert_eq(&ledger(&library("disk", "report-10s", r#"["q2", "u1"]"#)));
}

#[test]
fn the_proof_says_what_was_proved() {
    expect!["34 identities hold: the kinematic equations and Kane's of the whole model, its constants and outputs, along the reduced motion (in doubt by less than 2^-96)"].assert_eq(&library("disk", "report-10s", "").proof.to_string());
}
