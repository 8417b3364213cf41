//! Arms and trees of bodies with full inertias, as model text.

use std::fmt::Write;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::load;

/// Axes of the joints of an arm, over and over.
const AXES: [usize; 10] = [3, 2, 2, 1, 2, 1, 3, 2, 1, 3];

/// Reactions that a model text states.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Reactions {
    None,
    /// All five of every joint, which Newton's and Euler's equations ask for.
    All,
}

/// n bodies, body i hung on body `parent(i)` (0 is the ground) by a hinge or, where `slides(i)`, by a slide along the
/// joint's axis. Six inertias a body, its mass centre and the place of its joint off every axis, gravity.
pub fn tree_text(
    n: usize,
    parent: impl Fn(usize) -> usize,
    slides: impl Fn(usize) -> bool,
    reactions: Reactions,
) -> String {
    let mut text = format!("name = \"Tree of {n} bodies\"\n\n[parameters]\n");
    let mut line = |line: String| {
        text.push_str(&line);
        text.push('\n');
    };
    line("g = { unit = \"m/s^2\", value = 9.81, positive = true }".to_owned());
    for i in 1..=n {
        let size = f64::from(u32::try_from(i).unwrap());
        line(format!("m{i} = {{ unit = \"kg\", value = {:.2}, positive = true }}", 1.0 + 0.1 * size));
        for (at, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let at = [0.01, 0.02, 0.03][at];
            line(format!("c{axis}{i} = {{ unit = \"m\", value = {:.3} }}", 0.05 * size + at));
            line(format!("l{axis}{i} = {{ unit = \"m\", value = {:.3} }}", 0.2 + 0.03 * size + at));
            line(format!(
                "I{axis}{axis}{i} = {{ unit = \"kg*m^2\", value = {:.3}, positive = true }}",
                0.3 + 0.01 * size
            ));
        }
        for pair in ["xy", "yz", "zx"] {
            line(format!("I{pair}{i} = {{ unit = \"kg*m^2\", value = {:.4} }}", 0.01 + 0.001 * size));
        }
    }
    line("\n[coordinates]".to_owned());
    for i in 1..=n {
        line(format!("q{i} = {{ unit = \"{}\" }}", if slides(i) { "m" } else { "rad" }));
    }
    line("\n[speeds]".to_owned());
    for i in 1..=n {
        line(format!("u{i} = \"q{i}'\""));
    }
    line("\n[inertial]\nframe = \"A0\"\norigin = \"O\"\n\n[frames]".to_owned());
    let axis = |i: usize| AXES[(i - 1) % AXES.len()];
    for i in 1..=n {
        let angle = if slides(i) { "0.3".to_owned() } else { format!("q{i}") };
        line(format!("A{i} = {{ from = \"A{}\", axis = {}, angle = \"{angle}\" }}", parent(i), axis(i)));
    }
    line("\n[points]".to_owned());
    for i in 1..=n {
        let before = if parent(i) == 0 { "O".to_owned() } else { format!("P{}", parent(i)) };
        let place: Vec<String> = ["x", "y", "z"]
            .into_iter()
            .enumerate()
            .map(|(at, x)| if slides(i) && at + 1 == axis(i) { format!("l{x}{i} + q{i}") } else { format!("l{x}{i}") })
            .collect();
        line(format!("P{i} = {{ from = \"{before}\", frame = \"A{}\", position = {place:?} }}", parent(i)));
        line(format!("C{i} = {{ from = \"P{i}\", frame = \"A{i}\", position = [\"cx{i}\", \"cy{i}\", \"cz{i}\"] }}"));
    }
    line("\n[bodies]".to_owned());
    for i in 1..=n {
        line(format!(
            "b{i} = {{ frame = \"A{i}\", centre = \"C{i}\", mass = \"m{i}\", inertia = {{ frame = \"A{i}\", diagonal = \
             [\"Ixx{i}\", \"Iyy{i}\", \"Izz{i}\"], products = [\"Ixy{i}\", \"Iyz{i}\", \"Izx{i}\"] }} }}"
        ));
    }
    line("\n[gravity]\nframe = \"A0\"\nacceleration = [0, 0, \"-g\"]".to_owned());
    if reactions == Reactions::All {
        for i in 1..=n {
            for k in 1..=3 {
                let mut place = format!("on = \"b{i}\"\n");
                if parent(i) > 0 {
                    let _ = writeln!(place, "against = \"b{}\"", parent(i));
                }
                let direction: Vec<usize> = (1..=3).map(|at| usize::from(at == k)).collect();
                let _ = writeln!(place, "frame = \"A{i}\"\ndirection = {direction:?}");
                if k != axis(i) || !slides(i) {
                    line(format!("\n[reactions.F{i}_{k}]\nat = \"P{i}\"\n{place}"));
                }
                if k != axis(i) || slides(i) {
                    line(format!("\n[reactions.T{i}_{k}]\nkind = \"torque\"\n{place}"));
                }
            }
        }
    }
    text
}

/// The model of [`tree_text`].
pub fn tree(n: usize, parent: impl Fn(usize) -> usize, slides: impl Fn(usize) -> bool, reactions: Reactions) -> Model {
    let text = tree_text(n, parent, slides, reactions);
    load(&Source::from_text("tree/model.toml", &text)).unwrap_or_else(|e| panic!("{e}"))
}

/// An arm of n hinges.
pub fn arm(n: usize, reactions: Reactions) -> Model {
    tree(n, |i| i - 1, |_| false, reactions)
}
