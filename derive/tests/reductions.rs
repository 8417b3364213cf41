//! The reduced systems of the library as people read them: the least that the outputs need, and nothing of what they do
//! not.

use crate::reduced;

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
            u3 [1/s] = u3
            H_a3_there_scaled [kg*m^2/s] = 2*u3*(1 - sin(q2)) - u2*cos(q2)
            u3_times_4 [1/s] = 4*u3
            g_times_4 [m/s^2] = 4*g
            u3_times_2 [1/s] = 2*u3
            u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
            q2_minus_90deg' = -u1
            u1' = (cos(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) + u2^2/sin(q2_minus_90deg) + g_times_4) + u2*u3_times_2)/(4*sin(q2_minus_90deg)^2 - 5)
            q2 -> pi/2 + q2_minus_90deg
            upright while pi/2 - abs(pi/2 + q2_minus_90deg) > 0
            contact while (u1^2 + g*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + (H_a3_there_scaled - 4*u3*sin(q2_minus_90deg/2)^2)*(2*u3*sin(q2_minus_90deg) + (H_a3_there_scaled - 4*u3*sin(q2_minus_90deg/2)^2)/tan(q2_minus_90d…
            energy known; divided by: sin(q2_minus_90deg)
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
            u3 [1/s] = u3
            p_q4 [kg*m/s] = u1*sin(q1)*cos(q2) - u2*cos(q1)*tan(q2) + u4
            p_q5 [kg*m/s] = u5 - u1*cos(q1)*cos(q2) - u2*sin(q1)*tan(q2)
            H_a3_there_scaled [kg*m^2/s] = 2*u3*(1 - sin(q2)) - u2*cos(q2)
            centre_q4 [kg*m] = q4 - sin(q1)*sin(q2)
            centre_q5 [kg*m] = cos(q1)*sin(q2) + q5
            u3_times_4 [1/s] = 4*u3
            g_times_4 [m/s^2] = 4*g
            u3_times_2 [1/s] = 2*u3
            u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
            u5 = p_q5 - u1*cos(q1)*sin(q2_minus_90deg) - u2*sin(q1)/tan(q2_minus_90deg)
            u4 = u1*sin(q1)*sin(q2_minus_90deg) - u2*cos(q1)/tan(q2_minus_90deg) + p_q4
            q2_minus_90deg' = -u1
            q3' = u3 + u2/tan(q2_minus_90deg)
            q1' = -u2/sin(q2_minus_90deg)
            u1' = (cos(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) + u2^2/sin(q2_minus_90deg) + g_times_4) + u2*u3_times_2)/(4*sin(q2_minus_90deg)^2 - 5)
            q2 -> pi/2 + q2_minus_90deg
            q4 -> sin(q1)*cos(q2_minus_90deg) + p_q4*t + centre_q4
            q5 -> p_q5*t - cos(q1)*cos(q2_minus_90deg) + centre_q5
            upright while pi/2 - abs(pi/2 + q2_minus_90deg) > 0
            contact while (u1^2 + g*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + (H_a3_there_scaled - 4*u3*sin(q2_minus_90deg/2)^2)*(2*u3*sin(q2_minus_90deg) + (H_a3_there_scaled - 4*u3*sin(q2_minus_90deg/2)^2)/tan(q2_minus_90d…
            energy known; divided by: sin(q2_minus_90deg)
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
            u3 [1/s] = u3
            H_a3_there_scaled [kg*m^2/s] = 2*u3*(1 - sin(q2)) - u2*cos(q2)
            u3_times_4 [1/s] = 4*u3
            g_times_4 [m/s^2] = 4*g
            u3_times_2 [1/s] = 2*u3
            u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
            q2_minus_90deg' = -u1
            u1' = (cos(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) + u2^2/sin(q2_minus_90deg) + g_times_4) + u2*u3_times_2)/(4*sin(q2_minus_90deg)^2 - 5)
            N -> (u1^2 + g*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + u2*(2*u3*sin(q2_minus_90deg) + u2*cos(q2_minus_90deg))))/(sin(q2_minus_90deg)*(1 + 4*cos(q2_minus_90deg)^2))
            u1' -> (2*u2*u3 + cos(q2_minus_90deg)*(4*g + 4*u1^2*sin(q2_minus_90deg) + u2^2/sin(q2_minus_90deg)))/(4*sin(q2_minus_90deg)^2 - 5)
            q1' -> -u2/sin(q2_minus_90deg)
            upright while pi/2 - abs(pi/2 + q2_minus_90deg) > 0
            contact while (u1^2 + g*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1^2*cos(q2_minus_90deg) + (H_a3_there_scaled - 4*u3*sin(q2_minus_90deg/2)^2)*(2*u3*sin(q2_minus_90deg) + (H_a3_there_scaled - 4*u3*sin(q2_minus_90deg/2)^2)/tan(q2_minus_90d…
            energy known; divided by: sin(q2_minus_90deg)
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
            p_psi_there [kg*m^2/s] = I1*u2*sin(theta) + I3*u3*(cos(theta) - 1)
            p_phi [kg*m^2/s] = I3*u3
            p_phi_times_2 [1] = 2*I3*u3
            m_l_g [kg*m^2/s^2] = m*l*g
            u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
            u3 = p_phi/I3
            theta' = u1
            phi' = u3 - u2/tan(theta)
            psi' = u2/sin(theta)
            u1' = (m_l_g*sin(theta) - u2*(I3*u3 - I1*u2/tan(theta)))/I1
            regular while sin(theta) > 0
            energy known; divided by: sin(theta)
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
            u1' = u2^2/tan(theta) - g*sin(theta)
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
            p_psi_there [kg*m^2/s] = I1*w2*sin(theta) + w3*(cos(theta) - 1)/2
            w3 [1/s] = w3
            centre_x [kg*m] = 2*x
            centre_y [kg*m] = 2*y
            centre_z [kg*m] = 2*z
            p_z_by_2 [1] = v3
            p_y_by_2 [1] = v2
            p_x_by_2 [1] = v1
            w3_per_I1 [1/kg/m^2/s] = w3/I1
            w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
            v3 = p_z_by_2
            v2 = p_y_by_2
            v1 = p_x_by_2
            theta' = w1
            phi' = w3 - w2/tan(theta)
            psi' = w2/sin(theta)
            w1' = w2*(2*w2/tan(theta) - w3_per_I1)/2
            x -> p_x*t/2 + centre_x/2
            y -> p_y*t/2 + centre_y/2
            z -> p_z*t/2 + centre_z/2
            regular while sin(theta) > 0
            energy known; divided by: sin(theta)
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
            p_x [kg*m/s] = m*(6*u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3)))/2
            H_n3_scaled [kg*m^2/s] = m*l^2*(u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - …
            centre_x [kg*m] = m*(6*x + l*(2*cos(theta1) + 3*cos(theta2) + cos(theta3)))/2
            H_n3_scaled_per_m_per_l_squared [1] = u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(the…
            m_l_squared_by_12 [kg*m^2] = m*l^2/12
            u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(t…
            theta2_from_theta1' = u4_from_u3
            theta3_from_theta1' = u5_from_u3
            theta1' = u3
            (m_l_squared_by_12*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) - 18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) + co…
            (m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 + 3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 - 3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta…
            theta2 - theta1 -> theta2_from_theta1
            x -> (p_x*t + centre_x)/(3*m) - l*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 + theta3_from_theta1))/6
            energy known; divided by: 13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))
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
            p_q3 [kg*m^2/s] = I3*u3
            m_l_g [kg*m^2/s^2] = m*l*g
            u3 = p_q3/I3
            q1' = u1/cos(q2)
            q2' = u2
            q3' = u3 - u1*tan(q2)
            (I1)*u1' = u2*(I1*u1*tan(q2) - I3*u3) + m_l_g*sin(q1)
            (I1)*u2' = u1*(I3*u3 - I1*u1*tan(q2)) + m_l_g*cos(q1)*sin(q2)
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
            lB_times_3 [m] = 3*lB
            mA_lA_times_2 [kg*m] = 2*mA*lA
            g_by_2 [m/s^2] = g/2
            mA_lA_squared [kg*m^2] = mA*lA^2
            lB_squared_times_3_by_2 [m^2] = 3*lB^2/2
            theta' = omega
            phi' = alpha
            (IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)*omega' = 2*omega*alpha*sin(phi)*cos(phi)*(IByy - IBxx) - g_by_2*sin(theta)*(lB_times_3 + mA_lA_times_2)
            (IBzz)*alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)
            energy known; divided by: nothing
        "]],
    );
}

/// Nothing is conserved but the energy; the cart's place and speed follow from the links, whose equations do not have
/// them.
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
        u4 | no output and nothing that outputs need depends on u4 | no formula that is left mentions it
        u5 | no output and nothing that outputs need depends on u5 | no formula that is left mentions it
        u2 | u2 = (H_a3_there_scaled - 4*u3*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg), from what is constant: generalized speed, constant with the momentum p_q3 = ∂L/∂q3'; -4 times the angular momentum about a3 through the mass centre, what is left of it on the singular surface | Kane's equations of the whole model hold with it, by identity (in doubt by less than 2^-97)
        q1 | no output and nothing that outputs need depends on q1 | no formula that is left mentions it
        q3 | no output and nothing that outputs need depends on q3 | no formula that is left mentions it
        q4 | no output and nothing that outputs need depends on q4 | no formula that is left mentions it
        q5 | no output and nothing that outputs need depends on q5 | no formula that is left mentions it
    "]].assert_eq(&ledger(&library("disk", "report-10s", r#"["q2", "u1"]"#)));
}

#[test]
fn the_proof_says_what_was_proved() {
    expect!["34 identities hold: the kinematic equations and Kane's of the whole model, its constants and outputs, along the reduced motion (in doubt by less than 2^-97)"].assert_eq(&library("disk", "report-10s", "").proof.to_string());
}
