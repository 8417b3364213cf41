//! The publication of `tripos check` on a model: integrable constraints, and the poses that can be reached.
//!
//! Truth: textbook mechanisms. Bloch, *Nonholonomic Mechanics and Control*, 2nd edition (2015), §§1.4, 1.6 (rolling
//! disc, knife edge); Goldstein, Poole & Safko, *Classical Mechanics*, 3rd edition (2002), §1.3 (a disc that rolls
//! along a line is holonomic).

use crate::common::read;
use std::fmt::Write;
use std::path::Path;
use tripos_derive::Model;
use tripos_derive::check::{ModelCheck, check};

fn of_library(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).join("model.toml");
    std::fs::read_to_string(path).unwrap()
}

fn loaded(text: &str) -> Model {
    read(text).unwrap_or_else(|e| panic!("{e}"))
}

fn checked(text: &str) -> ModelCheck {
    let model = loaded(text);
    check(&model).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)))
}

/// (coordinates, degrees of freedom, freedom of configuration).
fn freedoms(found: &ModelCheck) -> (usize, usize, Option<usize>) {
    (found.coordinates, found.degrees_of_freedom, found.configuration_freedom)
}

/// (name, integrable, redundant) of each constraint.
fn constraints(found: &ModelCheck) -> Vec<(&str, Option<bool>, bool)> {
    found.constraints.iter().map(|c| (c.name.as_str(), c.integrable, c.redundant)).collect()
}

#[test]
fn a_rolling_disc_reaches_every_place() {
    let found = checked(&of_library("rolling_disc"));
    assert_eq!(freedoms(&found), (5, 3, Some(5)));
    let known: Vec<_> = found.constraints.iter().map(|c| (c.integrable, c.redundant)).collect();
    assert_eq!(known, [(Some(false), false), (Some(false), false), (None, true)], "{:?}", found.constraints);
}

#[test]
fn a_knife_edge_reaches_every_place_until_it_cannot_turn() {
    let text = of_library("knife_edge");
    let found = checked(&text);
    assert_eq!(freedoms(&found), (3, 2, Some(3)));
    assert_eq!(constraints(&found), [("edge", Some(false), false)]);
    // Held in its direction it goes along a line: then both hold functions of the place.
    let held = text.replace("w = \"phi'\"\n", "");
    assert_ne!(held, text);
    let found = checked(&format!("{held}\n[constraints.held]\nequation = \"phi' = 0\"\n"));
    assert_eq!(freedoms(&found), (3, 1, Some(1)));
    assert_eq!(constraints(&found), [("edge", Some(true), false), ("held", Some(true), false)]);
    assert_eq!(found.constraints[1].integral.as_deref(), Some("phi"));
}

#[test]
fn loops_are_of_configuration() {
    let found = checked(&of_library("four_bar"));
    assert_eq!(freedoms(&found), (3, 1, Some(1)));
    assert_eq!(constraints(&found), [("loop_x", Some(true), false), ("loop_y", Some(true), false)]);
    assert_eq!(found.singular_where, ["sin(q2 - q3)"]);
}

/// A disc that rolls along a line, with its drive.
fn rolling(drive: &str) -> String {
    format!(
        "name = \"disc\"\n[parameters]\nm = {{ unit = \"kg\", value = 2 }}\nr = {{ unit = \"m\", value = 0.3 }}\nv = {{ unit = \"m/s\", \
         value = 1 }}\nw = {{ unit = \"rad/s\", value = 1 }}\nspare = {{ unit = \"m\", value = 1 }}\n[coordinates]\nx = {{ unit = \"m\" \
         }}\ny = {{ unit = \"m\" }}\nq = {{ unit = \"rad\" }}\n[speeds]\nu = \"y'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n\
         [frames]\nB = {{ from = \"N\", axis = 3, angle = \"-q\" }}\n[points]\nC = {{ from = \"O\", frame = \"N\", position = [\"x\", \
         \"y\", 0] }}\nP = {{ from = \"C\", frame = \"N\", position = [0, \"-r\", 0] }}\n[bodies.disc]\nframe = \"B\"\ncentre = \
         \"C\"\nmass = \"m\"\ninertia = {{ diagonal = [\"m*r^2/4\", \"m*r^2/4\", \"m*r^2/2\"] }}\n[constraints]\nrolls = {{ equation = \
         \"v(disc, P) @ N [1] = 0\" }}\ndrive = {{ equation = \"{drive}\" }}\n"
    )
}

#[test]
fn rolling_along_a_line_is_integrable_and_so_is_a_drive() {
    for drive in ["x' = 0*v", "x' = v", "x' = v*cos(w*t)"] {
        let found = checked(&rolling(drive));
        assert_eq!(freedoms(&found), (3, 1, Some(1)), "{drive}");
        assert_eq!(constraints(&found), [("rolls", Some(true), false), ("drive", Some(true), false)], "{drive}");
        assert_eq!(found.constraints[0].integral.as_deref(), Some("x - r*q"), "{drive}");
        assert!(found.notes.contains(&"nothing names the parameter `spare`".to_owned()), "{:?}", found.notes);
        let drives = found.notes.iter().any(|note| note.contains("drive the mechanism"));
        assert_eq!(drives, drive != "x' = 0*v", "{drive}: {:?}", found.notes);
    }
    let last = checked(&rolling("x' = v*cos(w*t)"));
    assert_eq!(last.constraints[1].integral.as_deref(), Some("x - v*sin(w*t)/w"));
}

/// Goal: the freedoms of a bicycle. Truth: Meijaard, Papadopoulos, Ruina & Schwab 2007, §2: three velocities, seven
/// coordinates of an accessible configuration; its wheels add two more equations, which follow from coordinates and
/// other constraints.
#[test]
fn a_bicycle_has_three_velocities_and_seven_coordinates_to_choose() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/whipple_bicycle/model.toml");
    let found = checked(&std::fs::read_to_string(path).unwrap());
    assert_eq!(freedoms(&found), (8, 3, Some(7)));
    let count = |of: fn(&&tripos_derive::check::CheckedConstraint) -> bool| found.constraints.iter().filter(of).count();
    assert_eq!((count(|c| c.integrable == Some(false)), count(|c| c.redundant)), (4, 2), "{:?}", found.constraints);
}

/// Goal: a large mechanism without motion constraints is decided at once. Method: thirty particles on parallel lines.
#[test]
fn many_speeds_need_no_brackets() {
    let [mut coordinates, mut speeds, mut points, mut particles] = [const { String::new() }; 4];
    for i in 1..=30 {
        writeln!(coordinates, "x{i} = {{ unit = \"m\" }}").unwrap();
        writeln!(speeds, "u{i} = \"x{i}'\"").unwrap();
        writeln!(points, "P{i} = {{ from = \"O\", frame = \"N\", position = [\"x{i}\", 0, 0] }}").unwrap();
        writeln!(particles, "b{i} = {{ point = \"P{i}\", mass = \"m\" }}").unwrap();
    }
    let found = checked(&format!(
        "name = \"many\"\n[parameters]\nm = {{ unit = \"kg\" }}\n[coordinates]\n{coordinates}[speeds]\n{speeds}[inertial]\nframe = \"N\"\n\
         origin = \"O\"\n[points]\n{points}[particles]\n{particles}"
    ));
    assert_eq!(freedoms(&found), (30, 30, Some(30)));
    assert!(found.notes.is_empty(), "{:?}", found.notes);
}
