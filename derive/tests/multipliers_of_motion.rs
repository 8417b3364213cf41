//! Right rows with multipliers of an author who has put the constraints into the rows, and wrong ones.
//!
//! A disc rolls upright on a plane. By Newton's law, m a is the force of the contact. In the axes of the disc, of which
//! the second is perpendicular to its plane, it is m R θ'' along the path and m R θ' φ' across it. Its moment about the
//! axle is −R times the first.

use crate::constrained_verdicts::judge;

const DISC: &str = r#"
name = "Upright disc"
[parameters]
m = { unit = "kg", value = 0.7, positive = true }
R = { unit = "m", value = 1.01, positive = true }
I = { unit = "kg*m^2", value = 1.32, positive = true }
J = { unit = "kg*m^2", value = 1.63, positive = true }
[inputs]
tau1 = { unit = "N*m" }
tau2 = { unit = "N*m" }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
theta = { unit = "rad" }
phi = { unit = "rad" }
[speeds]
u1 = "theta'"
u2 = "phi'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "phi" }
B = { from = "A", axis = 2, angle = "theta" }
[points]
C = { from = "O", frame = "N", position = ["x", "y", "R"] }
D = { from = "O", frame = "N", position = ["x", "y", 0] }
[bodies.disk]
frame = "B"
centre = "C"
mass = "m"
inertia = { frame = "A", diagonal = ["J", "I", "J"] }
[torques.drive]
on = "disk"
frame = "A"
vector = [0, "tau1", "tau2"]
[rolling.roll]
body = "disk"
at = "D"
"#;

/// Words of the verdicts on printed rows, whose multipliers are P and Q.
fn verdicts(rows: &[&str]) -> Vec<String> {
    let rows: Vec<String> = rows.iter().map(|row| format!("\"{row}\"")).collect();
    let rows = rows.join(", ").replace('P', "lambda_roll_1").replace('Q', "lambda_roll_2");
    let publication =
        format!("[[system]]\nid = \"s\"\nsection = \"1\"\nformulation = \"lagrange\"\nequations = [{rows}]\n");
    let judged = judge(DISC, &publication);
    judged.difference.findings.iter().map(|finding| finding.judgement.word().to_owned()).collect()
}

#[test]
fn multipliers_in_the_axes_of_the_disc_are_the_authors_choice() {
    let (along, across) = ("m*R*theta'' = P", "m*R*theta'*phi' = Q");
    for rows in [
        &[along, across, "I*theta'' = tau1 - R*P", "J*phi'' = tau2"][..],
        &[along, "-m*R*theta'*phi' = Q", "I*theta'' = tau1 - R*P", "J*phi'' = tau2"],
        // Some of the rows.
        &[along, "I*theta'' = tau1 - R*P", "J*phi'' = tau2"],
        &[along, across],
        // Multipliers of another sign, and a moment.
        &["-m*R*theta'' = P", "I*theta'' = tau1 + R*P"],
        &["m*R^2*theta'' = P", "m*R*theta'*phi' = Q", "I*theta'' = tau1 - P", "J*phi'' = tau2"],
    ] {
        let words = verdicts(rows);
        assert!(words.iter().all(|word| ["equal", "scaled"].contains(&word.as_str())), "{rows:?}: {words:?}");
    }
}

#[test]
fn no_multipliers_make_wrong_rows_right() {
    for rows in [
        &["m*R*theta'' = P", "m*R*theta'*phi' = Q", "I*theta'' = tau1 + R*P", "J*phi'' = tau2"][..],
        &["m*R*theta'' = P", "I*theta'' = tau1 - 2*R*P", "J*phi'' = tau2"],
        &["2*m*R*theta'' = P", "m*R*theta'*phi' = Q"],
        &["m*R*theta'' = P", "m*R*theta'*phi' = P"],
        &["m*R*theta'' = P", "2*m*R*theta'*phi' = Q"],
        &["2*m*R*theta'*phi' = Q"],
        // A sign in the component across the path.
        &["m*(x''*cos(phi) + y''*sin(phi)) = P", "m*(x''*sin(phi) + y''*cos(phi)) = Q"],
        &["m*R*theta'' = P", "m*R*theta'*phi' = 2*Q", "I*theta'' = tau1 - R*Q"],
        &["m*R*theta'' = P", "m*R*theta'^2 = Q", "I*theta'' = tau1 - R*P"],
        &["m*R*theta'' = P", "m*R*theta'*phi' = Q", "I*theta'' = tau1 - R*P*cos(phi)"],
        &["m*R*theta'' = P", "m*R*theta'*phi'*sin(phi) = Q", "I*theta'' = tau1 - R*P"],
    ] {
        let words = verdicts(rows);
        assert!(words.contains(&"different".to_owned()), "{rows:?}: {words:?}");
    }
}

/// Goal: one mistake is one wrong row. Method: the Coriolis term is doubled, and the other rows are right.
#[test]
fn right_rows_beside_a_wrong_one_keep_their_multipliers() {
    let rows = ["m*R*theta'' = P", "2*m*R*theta'*phi' = Q", "I*theta'' = tau1 - R*P", "J*phi'' = tau2"];
    assert_eq!(verdicts(&rows), ["scaled", "different", "equal", "equal"]);
}

/// Goal: one choice of multipliers holds for all entries. Method: rows in entries of their own, one of them wrong.
#[test]
fn multipliers_of_one_entry_are_those_of_the_others() {
    let of = |rows: &[&str]| -> Vec<String> {
        let entry = |(at, row): (usize, &&str)| {
            let row = row.replace('P', "lambda_roll_1").replace('Q', "lambda_roll_2");
            format!(
                "[[system]]\nid = \"s{at}\"\nsection = \"1\"\nformulation = \"lagrange\"\nequations = [\"{row}\"]\n"
            )
        };
        let publication: String = rows.iter().enumerate().map(entry).collect();
        let judged = judge(DISC, &publication);
        judged.difference.findings.iter().map(|finding| finding.judgement.word().to_owned()).collect()
    };
    let right = of(&["m*R*theta'' = P", "m*R*theta'*phi' = Q", "I*theta'' = tau1 - R*P", "J*phi'' = tau2"]);
    assert!(!right.contains(&"different".to_owned()), "{right:?}");
    let wrong = of(&["m*R*theta'' = P", "m*R*theta'*phi' = Q", "I*theta'' = tau1 + R*P", "J*phi'' = tau2"]);
    assert!(wrong.contains(&"different".to_owned()), "{wrong:?}");
}
