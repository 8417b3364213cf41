//! Pendulums of many links on a cart, as model text.
#![allow(dead_code, reason = "each user needs a part")]

use std::fmt::Write;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::load;

/// A cart on a rail, pushed, and n links that turn about one axis, a mass at the end of each: `models/cart_pendulum_3`
/// for any n.
pub fn chain_text(n: usize) -> String {
    let mut text = format!("name = \"Chain of {n} on a cart\"\n\n[parameters]\n");
    let mut line = |line: String| {
        text.push_str(&line);
        text.push('\n');
    };
    for i in 0..=n {
        line(format!("m{i} = {{ unit = \"kg\", value = 1, positive = true }}"));
    }
    for i in 1..=n {
        line(format!("l{i} = {{ unit = \"m\", value = 0.5, positive = true }}"));
    }
    line("g = { unit = \"m/s^2\", value = 9.81, positive = true }\nF = { unit = \"N\", value = 2.75 }".to_owned());
    line("\n[coordinates]\nq0 = { unit = \"m\" }".to_owned());
    for i in 1..=n {
        line(format!("q{i} = {{ unit = \"rad\" }}"));
    }
    line("\n[speeds]".to_owned());
    for i in 0..=n {
        line(format!("u{i} = \"q{i}'\""));
    }
    line("\n[inertial]\nframe = \"N\"\norigin = \"O\"\n\n[frames]".to_owned());
    for i in 1..=n {
        line(format!("B{i} = {{ from = \"N\", axis = 3, angle = \"q{i}\" }}"));
    }
    line("\n[points]\nP0 = { from = \"O\", frame = \"N\", position = [\"q0\", 0, 0] }".to_owned());
    for i in 1..=n {
        line(format!("P{i} = {{ from = \"P{}\", frame = \"B{i}\", position = [0, \"l{i}\", 0] }}", i - 1));
    }
    line("\n[particles]\ncart = { point = \"P0\", mass = \"m0\" }".to_owned());
    for i in 1..=n {
        line(format!("bob{i} = {{ point = \"P{i}\", mass = \"m{i}\" }}"));
    }
    line("\n[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]".to_owned());
    line("\n[forces.drive]\non = \"cart\"\nframe = \"N\"\nvector = [\"F\", 0, 0]".to_owned());
    line("\n[reactions.rail]\non = \"cart\"\nframe = \"N\"\ndirection = [0, 1, 0]".to_owned());
    for i in 1..=n {
        let before = if i == 1 { "cart".to_owned() } else { format!("bob{}", i - 1) };
        let place = format!("on = \"bob{i}\"\nagainst = \"{before}\"\nframe = \"B{i}\"\ndirection = [0, 1, 0]");
        line(format!("\n[reactions.T{i}]\n{place}"));
    }
    text
}

/// The model of [`chain_text`].
pub fn chain(n: usize) -> Model {
    load(&Source::from_text("chain/model.toml", &chain_text(n))).unwrap_or_else(|e| panic!("{e}"))
}

/// The chain of [`chain_text`] with every angle from the link before.
pub fn relative_chain(n: usize) -> Model {
    let mut text = chain_text(n);
    for i in 2..=n {
        let [absolute, relative] = ["N", &format!("B{}", i - 1)].map(|from| format!("B{i} = {{ from = \"{from}\""));
        text = text.replace(&absolute, &relative);
    }
    load(&Source::from_text("chain/model.toml", &text)).unwrap_or_else(|e| panic!("{e}"))
}

/// Row by row, M and f of [`chain`] as Lagrange's equations give them by hand, in u_i = q_i'. With μ_i the mass of link
/// i and all beyond it, l_0 = 1 and the cart moving along the first axis:
/// M_ij = μ_j l_i l_j cos(q_i − q_j),  M_0j = −μ_j l_j cos q_j  for i ≤ j,
/// f_i = μ_i g l_i sin q_i − Σ_j μ_max(i,j) l_i l_j sin(q_i − q_j) u_j²,  f_0 = F − Σ_j μ_j l_j sin q_j u_j².
pub fn by_hand(n: usize) -> (Vec<Vec<String>>, Vec<String>) {
    let beyond = |i: usize| format!("({})", (i..=n).map(|k| format!("m{k}")).collect::<Vec<_>>().join(" + "));
    let entry = |i: usize, j: usize| {
        let (i, j) = (i.min(j), i.max(j));
        match (i, j) {
            (0, 0) => beyond(0),
            (0, j) => format!("-{}*l{j}*cos(q{j})", beyond(j)),
            (i, j) => format!("{}*l{i}*l{j}*cos(q{i} - q{j})", beyond(j)),
        }
    };
    let matrix = (0..=n).map(|i| (0..=n).map(|j| entry(i, j)).collect()).collect();
    let mut forcing = vec!["F".to_owned()];
    for i in 1..=n {
        let _ = write!(forcing[0], " - {}*l{i}*sin(q{i})*u{i}^2", beyond(i));
        let mut right = format!("{}*g*l{i}*sin(q{i})", beyond(i));
        for j in 1..=n {
            let _ = write!(right, " - {}*l{i}*l{j}*sin(q{i} - q{j})*u{j}^2", beyond(i.max(j)));
        }
        forcing.push(right);
    }
    (matrix, forcing)
}
