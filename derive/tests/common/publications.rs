//! A small right publication on the base model, and what is said about edits of it.

#![allow(dead_code, reason = "each test file uses a part")]

use crate::common::{BASE, read};
use expect_test::Expect;
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::publication::{Publication, load_publication};

/// A right publication on the pendulum on a cart, with a reaction-free Newton–Euler part left out.
pub const PUBLICATION: &str = r#"title = "A pendulum"
source = "a blackboard"

[abbreviations]
s = "sin(q)"
bob = "m*length*s"

[names]
T = "T"
vx = "v(C) @ N [1]"

[[equation]]
id = "1-vx"
section = "1"
quantity = "v(C) @ N [1]"
printed = "u1 + length*cos(q)*u2"
note = "a note"

[[definition]]
id = "1-text"
section = "1"
printed = "F = m a"

[[equation]]
id = "2-T"
section = "2"
quantity = "T"
printed = "T + 0*vx"
repaired = "a stain, read as 0"

[[system]]
id = "3"
section = "3"
formulation = "lagrange"
unknowns = ["x''", "q''"]
matrix = [["2*m", "m*length*cos(q)"], ["m*length*cos(q)", "I + m*length^2"]]
right = ["bob*q'^2", "-g*bob"]
matrix_ids = "3-E{i}{j}"
right_ids = "3-A{i}"

[[listing]]
id = "code"
section = "A"
formulation = "kane"
state = ["q", "x", "u2", "u1"]
derivative = ["u2", "u1", "-g*bob", 0]
matrix = [[1, 0], [0, "m"]]

[[initial]]
id = "4-q"
section = "4"
set = "text"
quantity = "q"
printed = "10*pi/180"

[[initial]]
id = "4-x'"
section = "4"
set = "text"
quantity = "x'"
printed = -0.250
"#;

pub fn base() -> Model {
    read(BASE).unwrap_or_else(|e| panic!("{e}"))
}

pub fn load_text(text: &str, model: &mut Model) -> Result<Publication, Diagnostics> {
    load_publication(&Source::from_text("publication.toml", text), model)
}

/// The right publication with pieces replaced, each of which must be there.
pub fn edited(edits: &[(&str, &str)]) -> String {
    let mut text = PUBLICATION.to_owned();
    for (old, new) in edits {
        assert!(text.contains(old), "the publication has no `{old}`");
        text = text.replacen(old, new, 1);
    }
    text
}

pub fn errors(text: &str) -> Diagnostics {
    match load_text(text, &mut base()) {
        Err(diagnostics) => diagnostics,
        Ok(_) => panic!("this must not be accepted:\n{}", &text[..text.len().min(3000)]),
    }
}

pub fn check(text: &str, expected: &Expect) {
    let lines: Vec<String> = errors(text).to_string().lines().map(|l| l.trim_end().to_owned()).collect();
    expected.assert_eq(&lines.join("\n"));
}

pub fn check_edit(old: &str, new: &str, expected: &Expect) {
    check(&edited(&[(old, new)]), expected);
}
