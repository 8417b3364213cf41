//! A small correct model, and what is said about edits of it.
#![allow(dead_code, reason = "each test file uses a part")]

use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::model::load;
use tripos_derive::{Formulation, Model, derive};

/// A pendulum on a cart, correct.
pub const BASE: &str = r#"name = "Pendulum on a cart"

[parameters]
m = { unit = "kg", value = 2, positive = true }
length = { unit = "m", value = 0.5, positive = true }
I = { unit = "kg*m^2", value = 0.1, positive = true }
g = { unit = "m/s^2", value = 9.81 }

[coordinates]
x = { unit = "m" }
q = { unit = "rad" }

[speeds]
u1 = "x'"
u2 = "q'"

[inertial]
frame = "N"
origin = "O"

[frames]
A = { from = "N", axis = 3, angle = "q" }

[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
C = { from = "P", frame = "A", position = [0, "-length", 0] }

[particles]
cart = { point = "P", mass = "m" }

[bodies.rod]
frame = "A"
centre = "C"
mass = "m"
inertia = { diagonal = ["I", 0, "I"] }

[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

/// The base with pieces replaced, each of which must be there, and an addition at the end.
pub fn edited(edits: &[(&str, &str)], addition: &str) -> String {
    let mut text = BASE.to_owned();
    for (old, new) in edits {
        assert!(text.contains(old), "the base has no `{old}`");
        text = text.replacen(old, new, 1);
    }
    text + addition
}

/// Reads a text as `model.toml`.
pub fn read(text: &str) -> Result<Model, Diagnostics> {
    load(&Source::from_text("model.toml", text))
}

/// The errors of a text, of reading it or else of deriving it by Kane's method.
pub fn errors(text: &str) -> Diagnostics {
    match read(text) {
        Err(diagnostics) => diagnostics,
        Ok(model) => match derive(&model, Formulation::Kane) {
            Err(error) => model.diagnose(&error),
            Ok(_) => panic!("this must not be accepted:\n{}", &text[..text.len().min(3000)]),
        },
    }
}

/// Line and column, from 1, in characters, of a byte of the text.
pub fn place(text: &str, at: usize) -> (usize, usize) {
    let line = text[..at].matches('\n').count() + 1;
    let start = text[..at].rfind('\n').map_or(0, |n| n + 1);
    (line, text[start..at].chars().count() + 1)
}
